"""Grammars of motion (Park, Lee, Lee 2011): terminals, sentences, rules, new sentences."""
