"""Prints the data of a report as JSON: data_of.py REPORT.html [KEY ...], of these keys, one inside the other, alone"""
import json
import re
import sys

page = open(sys.argv[1], encoding="utf-8").read()
data = json.loads(re.search(r'<script type="application/json" id="data">(.*?)</script>', page, re.DOTALL).group(1))
for key in sys.argv[2:]:
    data = data[int(key) if isinstance(data, list) else key]
print(json.dumps(data, indent=1, ensure_ascii=False))
