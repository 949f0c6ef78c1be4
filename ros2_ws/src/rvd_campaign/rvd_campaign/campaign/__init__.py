"""
Campaigns: thousands of approaches in process, in paired conditions, with intervals and figures.

spec        the campaign file: base scenario, conditions, grid; checked before the first run
engine      chunks of runs on worker processes, finished parts on disk, resume
results     the result table, its hash, `results.parquet` and `summary.json`
stats       intervals for proportions, for their paired differences and for means
figures     what the report shows
report      `report.html`
calibrate   fits the pilot's free numbers to condition 1 and says what that can identify
"""
