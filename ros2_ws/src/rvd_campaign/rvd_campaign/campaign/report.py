def write_campaign_report(folder):
    return folder
