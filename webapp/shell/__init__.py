"""The frame around all pages: navigation, links, settings, playback, access, and messages for people."""
