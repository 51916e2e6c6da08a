"""Files of statistics that `taut simulate --stats` writes."""
import json


def records_without_times(file):
    """Every line of a .csv or .jsonl file, without what the clock said."""
    lines = file.read_text().splitlines()
    if file.suffix == '.csv':
        timed = [i for i, name in enumerate(lines[0].split(',')) if name.endswith('_ms')]
        return [[cell for i, cell in enumerate(line.split(',')) if i not in timed] for line in lines]
    records = [json.loads(line) for line in lines]
    for record in records:
        for measured in (record, record.get('summary', {})):
            for key in [key for key in measured if key.endswith('_ms')]:
                del measured[key]
    return records
