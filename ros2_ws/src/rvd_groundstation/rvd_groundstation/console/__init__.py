"""
The browser console: access, lease, feed, command ladder, session desk, review.

`node`, `process` and `main` are its side to ROS; the page's sources are in `console_web`.
"""
