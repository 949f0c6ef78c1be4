"""
The ground segment: nothing yet. The approach flies by itself; a pilot and a link come later.
"""
