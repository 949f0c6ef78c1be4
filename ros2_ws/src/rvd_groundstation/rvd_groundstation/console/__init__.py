"""
The browser console without ROS: access, lease, feed, command ladder, session desk, review.

The ROS side is `rvd_groundstation.console.node`; the page's sources are in `console_web`.
"""
