"""
Campaigns: thousands of approaches in process, in paired conditions, with intervals and figures.

spec        the campaign file: base scenario, conditions, grid; checked before the first run
engine      chunks of runs on worker processes, finished parts on disk, resume
results     the result table, its hash, `results.parquet` and `summary.json`
stats       intervals for proportions, for their paired differences and for means
figures     what the report shows
report      `report.html`
fit         fits a pilot's free numbers to condition 1
calibrate   the command: fits, and says what condition 1 can identify
sample      points over what is not known of a scenario; `ensemble` says what they give
beside      what other campaigns say of the same conditions
"""
