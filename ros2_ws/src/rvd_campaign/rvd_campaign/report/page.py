"""
The look of a report.
"""

STYLE = '''
:root{color-scheme:light dark;--font:system-ui,-apple-system,"Segoe UI",Roboto,"Helvetica Neue",
Arial,sans-serif;--paper:#fff;--panel:#f6f7f9;--ink:#16191d;--muted:#6b7280;--faint:#d5d9df;
--blue:#0072b2;--vermillion:#d55e00;--green:#009e73;--orange:#e69f00}
@media (prefers-color-scheme:dark){:root{--paper:#14171b;--panel:#1d2127;--ink:#e7eaee;
--muted:#98a1ad;--faint:#343a43;--blue:#56b4e9;--vermillion:#f28a45;--green:#2fc49a;
--orange:#f0b740}}
*{box-sizing:border-box}
body{margin:0;background:var(--paper);color:var(--ink);font:15px/1.5 var(--font)}
header{padding:1.4rem max(1rem,calc(50vw - 30rem)) 1.1rem;border-bottom:3px solid var(--muted);
background:var(--panel)}
header.good{border-color:var(--green)}header.bad{border-color:var(--vermillion)}
header.good .mark{color:var(--green)}header.bad .mark{color:var(--vermillion)}
h1{margin:0;font-size:1.55rem;line-height:1.25}header p{margin:.4rem 0 0;color:var(--muted)}
header b{color:var(--ink);font-weight:600}
main{max-width:62rem;margin:0 auto;padding:0 1rem 3rem}
h2{font-size:1.12rem;margin:2rem 0 .5rem}figure{margin:0}
svg{display:block;width:100%;height:auto}
svg text{font-family:var(--font)!important}
figcaption{color:var(--muted);font-size:.87rem;max-width:54rem;margin-top:.2rem}
table{border-collapse:collapse;font-variant-numeric:tabular-nums;font-size:.92rem}
th{text-align:left;color:var(--muted);font-weight:600}
th,td{padding:.22rem 1.1rem .22rem 0;border-bottom:1px solid var(--faint)}
table.wide{width:100%}
table.numbers td+td,table.numbers th+th{text-align:right;padding-left:1.4rem}
.meter{display:block;width:9rem;height:.55rem;border-radius:.3rem;background:var(--faint)}
.meter span{display:block;height:100%;border-radius:.3rem;background:var(--green)}
.meter .bad{background:var(--vermillion)}
.warning{border-left:4px solid var(--vermillion);background:var(--panel);padding:.7rem 1rem;
margin:1.2rem 0 0}
details summary{cursor:pointer}details h2{display:inline}
pre{background:var(--panel);padding:1rem;overflow:auto;font-size:.82rem;line-height:1.4}
@media print{:root{--paper:#fff;--panel:#fff;--ink:#000;--muted:#444;--faint:#ccc;--blue:#0072b2;
--vermillion:#d55e00;--green:#009e73;--orange:#e69f00}body{font-size:10pt}
figure,table,section{break-inside:avoid}h2{break-after:avoid}
header{padding-left:0;padding-right:0}main{padding:0;max-width:none}}
'''
