"""Parts that pages are made of: the parameter form, the page of a method, tables, charts and small drawings."""
