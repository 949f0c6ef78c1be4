"""
`./rvd campaign`: from the command line to a folder with results and a report.
"""

import argparse
import json
import signal
import sys
import warnings
from dataclasses import replace
from pathlib import Path

from rvd_campaign.campaign import engine
from rvd_campaign.campaign.checked import Campaign, check_runs
from rvd_campaign.campaign.engine import KEPT, Workers
from rvd_campaign.campaign.progress import clock, Progress
from rvd_campaign.campaign.spec import load_campaign
from rvd_campaign.campaign.summary import CONFIRMED, finish, in_words, SUMMARY
from rvd_campaign.exits import CannotRun, EXIT_DONE, EXIT_INTERRUPTED
from rvd_campaign.flight.run_folder import new_folder
from rvd_campaign.interrupts import all_like_ctrl_c
from rvd_campaign.report.attempt import attempt
from rvd_dynamics.recording import whole

MAX_WORKERS = 256


def main(args: argparse.Namespace) -> int:
    """Fly a campaign as the command line asks; return the exit code."""
    workers = _workers(args)
    campaign, folder = _resumed(args) if args.resume else _new(args)
    all_like_ctrl_c()
    print(f'{campaign.name}: {len(campaign.conditions)} conditions of {campaign.runs:,} runs, '
          f'seed {campaign.seed}, {folder}', flush=True)
    again = campaign.again
    progress = Progress()
    try:
        with engine.sole_writer(folder), warnings.catch_warnings():
            warnings.simplefilter('ignore')     # of worker pools that are ended on purpose
            engine.fly_campaign(campaign, folder, workers, progress)
            if again:
                progress = Progress()
                print(f'again with seed {again.seed}: {again.runs:,} runs of each condition',
                      flush=True)
                beside = _beside(again, folder)
                with engine.sole_writer(beside):
                    engine.fly_campaign(again, beside, workers, progress)
    except KeyboardInterrupt:
        _stay_dead()
        progress.end()
        print(f'stopped: {progress.done:,} of {progress.total:,} runs are finished; go on with '
              f'./rvd campaign --resume {folder}', flush=True)
        return EXIT_INTERRUPTED
    _finish(campaign, folder)
    if progress.flown:
        rate = progress.flown / progress.elapsed_s
        print(f'{progress.flown:,} runs in {clock(progress.elapsed_s)}, {rate:,.0f} runs/s')
    return EXIT_DONE


def _beside(again: Campaign, folder: Path) -> Path:
    """Return the folder of the confirmation, which goes on where it stopped."""
    beside = folder / CONFIRMED
    try:
        if (beside / KEPT).exists():
            _, kept = engine.open_folder(beside)
            engine.check_same(beside, kept, again)
            engine.keep(again, beside)
        else:
            beside.mkdir(exist_ok=True)
            engine.start(again, beside)
    except OSError as error:
        raise engine.full_disk(beside, error) from None
    return beside


def _finish(campaign: Campaign, folder: Path) -> None:
    from rvd_campaign.campaign.report import write_campaign_report
    summary = finish(campaign, folder)
    try:
        whole.write_text(folder / SUMMARY, json.dumps(summary, indent=1) + '\n')
        print(in_words(summary))
        print(f'result hash {summary["result_hash"]}', flush=True)
    except OSError as error:
        raise engine.full_disk(folder, error) from None
    attempt(write_campaign_report, folder, folder / 'report.log')


def _stay_dead() -> None:
    """A second Ctrl-C while we say good-bye changes nothing."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    sys.stdout.flush()


def _workers(args: argparse.Namespace) -> Workers:
    count = args.workers if args.workers is not None else engine.default_workers()
    if not 1 <= count <= MAX_WORKERS:
        raise CannotRun(f'--workers must be 1 to {MAX_WORKERS}, got {count}')
    if args.batch is not None and args.batch < 1:
        raise CannotRun(f'--batch must be at least 1, got {args.batch}')
    if (args.backend != 'local') != bool(args.scheduler):
        raise CannotRun('--backend dask or ray and --scheduler ADDRESS need each other')
    if args.scheduler:
        engine.check_scheduler(args.backend, args.scheduler)
    return Workers(count, args.backend, args.scheduler or '', args.batch or 0)


def _new(args: argparse.Namespace) -> tuple[Campaign, Path]:
    if args.campaign is None:
        raise CannotRun('give a campaign file, a name in `rvd list campaigns`, or --resume DIR')
    campaign = load_campaign(args.campaign, args.runs)
    if args.out is not None and (Path(args.out) / KEPT).exists():
        raise CannotRun(f'--out {args.out} holds a campaign already: nothing is overwritten; '
                        f'go on with it by --resume {args.out}, or give another folder')
    runs = campaign.runs + (campaign.confirm.runs if campaign.confirm else 0)
    engine.check_space(_standing(Path(args.out or 'runs')), runs * len(campaign.conditions))
    folder = new_folder(args.out, campaign.name)
    try:
        engine.start(campaign, folder)
    except FileExistsError:
        raise CannotRun(f'--out {folder} has just been taken by another campaign: give another '
                        'folder') from None
    except OSError as error:
        raise engine.full_disk(folder, error) from None
    return campaign, folder


def _resumed(args: argparse.Namespace) -> tuple[Campaign, Path]:
    folder = Path(args.resume)
    if args.out is not None:
        raise CannotRun('--resume goes on in its own folder: leave out --out')
    campaign, kept = engine.open_folder(folder)
    if args.campaign is not None:
        campaign = load_campaign(args.campaign, args.runs or campaign.runs)
    if args.runs is not None:
        check_runs(args.runs, len(campaign.conditions))
        campaign = replace(campaign, runs=args.runs)
    engine.check_same(folder, kept, campaign)
    try:
        engine.keep(campaign, folder)
    except OSError as error:
        raise engine.full_disk(folder, error) from None
    return campaign, folder


def _standing(folder: Path) -> Path:
    """Return the nearest folder above that exists: its disk is the one that fills."""
    folder = folder.absolute()
    while not folder.is_dir():
        folder = folder.parent
    return folder
