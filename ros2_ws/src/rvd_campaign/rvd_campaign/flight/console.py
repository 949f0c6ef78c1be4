"""
`./rvd fly --operator console`: one page, one run after the other.

The console process is started once and outlives runs; each run is a bring-up of its own in a
new folder. Control channel: lines of JSON on the console's standard output (a URL, wishes of
the pilot, in the end what was refused) and input (how a run goes).
"""

import argparse
import json
import os
import queue
import subprocess
import sys
import tempfile
import threading
from pathlib import Path
from typing import Any

from rvd_campaign.flight import choice, fly, leftovers, run_folder
from rvd_campaign.exits import CannotRun, EXIT_CANNOT, EXIT_DONE, EXIT_INTERRUPTED
from rvd_campaign.flight.domain import reserved_domain
from rvd_campaign.interrupts import all_like_ctrl_c
from rvd_dynamics import lifeline
from rvd_dynamics.bad_input import BadInput, one_line
from rvd_dynamics.diagram.display import as_data
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.recording import whole
from rvd_groundstation.console.forms import with_wishes
from rvd_groundstation.console.provider import display_of

URL_S = 30.0                    # [s] wall time for the page to be there
LOOK_S = 0.2                    # [s] wall time between two looks at the process
STOP_S = 5.0                    # [s] wall time it gets to end


class ConsoleProcess:
    """The console as a child process; its wishes come in order."""

    def __init__(self, args: argparse.Namespace, runs: Path, folder: Path, domain: int,
                 scenario: Scenario) -> None:
        self.socket = folder / 'console'
        display = folder / 'display.json'       # for pages that open before the first run
        shown = display_of(scenario)
        whole.save(display, json.dumps({'display': as_data(shown.display),
                                        'mode': shown.facts.mode}))
        command = [sys.executable, '-m', 'rvd_groundstation.console.main', '--serve',
                   '--socket', str(self.socket), '--runs', str(runs), '--bind', args.bind,
                   '--display', str(display),
                   '--port', str(args.port), '--tls-cert', args.tls_cert,
                   '--tls-key', args.tls_key]
        if args.session:
            command += ['--session', args.session]
        self._process = subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
            start_new_session=True,
            env={**os.environ, 'ROS_DOMAIN_ID': str(domain), 'RVD_LEAN': '1',
                 lifeline.PARENT: str(os.getpid()), 'ROS_LOG_DIR': str(folder),
                 'OMP_NUM_THREADS': '1', 'OPENBLAS_NUM_THREADS': '1'})
        self._wishes: queue.Queue[dict] = queue.Queue()
        self._held: dict | None = None          # a wish for after the run under way
        self._refused = ''
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def _read(self) -> None:
        for line in self._process.stdout:
            try:
                message = dict(json.loads(line))
            except (ValueError, TypeError):
                print(one_line(line.rstrip('\n')), flush=True)
                continue
            if 'refused' in message:
                self._refused = message['refused']
            else:
                self._wishes.put(message)

    def urls(self) -> tuple[str, str]:
        """Return the address for who flies and the one for who only watches, once there."""
        try:
            said = self._next(URL_S)
            return said['url'], said['watch']
        except (KeyError, queue.Empty):
            raise CannotRun('the console did not start') from None

    def _next(self, patience_s: float = float('inf')) -> dict[str, Any]:
        waited = 0.0
        while True:
            try:
                return self._wishes.get(timeout=LOOK_S)
            except queue.Empty:
                waited += LOOK_S
                code = self._process.poll()
                if code == EXIT_CANNOT:
                    raise SystemExit(code) from None        # it has said why, in one line
                if code is not None:
                    raise CannotRun('the console has gone (see above)') from None
                if waited > patience_s:
                    raise

    def wish(self) -> dict[str, Any]:
        """Return the next wish of the pilot, waiting for it."""
        held, self._held = self._held, None
        return held if held is not None else self._next()

    def stop_asked(self) -> bool:
        """Say whether the run under way is to stop: for another one, or for good."""
        if self._held is None:
            try:
                self._held = self._wishes.get_nowait()
            except queue.Empty:
                return self._process.poll() is not None
        if self._held['do'] == 'stop':
            self._held = None
            return True
        return True

    def tell(self, phase: str, run: str, note: str = '') -> None:
        """Let the page know how it goes with a run (its folder below the runs folder)."""
        message = {'phase': phase, 'run': run, 'note': note}
        try:
            self._process.stdin.write(json.dumps(message) + '\n')
            self._process.stdin.flush()
        except (BrokenPipeError, ValueError):
            pass                                # its end is noticed where wishes are awaited

    def stop(self) -> str:
        """End the process, whose standard input ends; return what it refused, in words."""
        try:
            self._process.stdin.close()
        except BrokenPipeError:
            pass
        try:
            self._process.wait(STOP_S)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        self._reader.join(LOOK_S)
        return self._refused


def main(args: argparse.Namespace, scenario: Scenario) -> int:
    """Serve the page and fly what it asks for; return the exit code of the last run."""
    runs = Path(args.out).parent if args.out else Path('runs')
    if args.session:
        if args.out is None:
            raise CannotRun('--session needs --out DIR, the folder of all its volunteers')
        runs = Path(args.out)
    try:
        runs.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise CannotRun(f'cannot make the folder of the runs {runs}: {error.strerror}') from None
    all_like_ctrl_c()
    with reserved_domain() as domain, tempfile.TemporaryDirectory(prefix='rvd-') as folder:
        domain.held_for(f'the console of {runs.absolute()}')
        if removed := leftovers.remove(domain).in_words():
            print(removed, flush=True)
        page = ConsoleProcess(args, runs, Path(folder), domain, scenario)
        os.environ['RVD_CONSOLE'] = str(page.socket)
        try:
            print('open {}\nwatch {}'.format(*page.urls()), flush=True)
            return _serve(page, args, scenario, runs, domain)
        finally:
            refused = page.stop()
            if refused:
                print(refused, flush=True)


def _serve(page: ConsoleProcess, args: argparse.Namespace, scenario: Scenario, runs: Path,
           domain: int) -> int:
    code, flown = EXIT_INTERRUPTED, 0
    try:
        while True:
            wish = page.wish()
            if wish['do'] == 'quit':
                return EXIT_DONE if flown == 0 else code
            if wish['do'] != 'fly':
                continue
            try:
                asked = _as_wished(scenario, wish, flown)
            except BadInput as error:
                page.tell('refused', '', _told(error, scenario))
                continue
            out = _folder(args, wish, runs, flown)
            run_dir = run_folder.new_folder(None if out is None else str(out), asked.name)
            code = _fly(page, asked, run_dir, runs, domain, args.headless)
            flown += 1
    except KeyboardInterrupt:
        return code


def _as_wished(scenario: Scenario, wish: dict[str, Any], flown: int) -> Scenario:
    """Return the scenario of the next run: each has a seed of its own."""
    values = {'seed': wish.get('seed', scenario.run.seed + flown)}
    if 'mode' in wish and scenario.has_shared('mode'):
        values['mode'] = wish['mode']
    asked = scenario.with_values('/**', **values)
    if 'settings' in wish:
        asked = with_wishes(asked, display_of(scenario).display.forms, wish['settings'])
    return asked


def _told(error: BadInput, scenario: Scenario) -> str:
    """Return why a wish is refused, without the name of the scenario, which the page knows."""
    return str(error).removeprefix(f'scenario {scenario.name}: ')


def _folder(args: argparse.Namespace, wish: dict[str, Any], runs: Path, flown: int
            ) -> Path | None:
    if 'out' in wish:                           # the session says where
        return runs / wish['out']
    if args.out is None:
        return None
    return Path(args.out) if flown == 0 else Path(f'{args.out}-{flown + 1}')


def _fly(page: ConsoleProcess, scenario: Scenario, run_dir: Path, runs: Path, domain: int,
         headless: bool) -> int:
    run_folder.keep_scenario(run_dir, scenario)
    print(f'{choice.introduced(scenario)}, {run_dir}', flush=True)
    name = os.path.relpath(run_dir, runs)
    page.tell('starting', name)
    stopped = []

    def stop_asked() -> bool:
        if page.stop_asked():
            stopped.append(True)
        return bool(stopped)

    def known(code: int) -> None:
        """Let the page go on: the run is over, and who flew need not wait for the report."""
        if code != EXIT_INTERRUPTED or stopped:
            page.tell('ended', name, f'failed {flight.problem}' if code == EXIT_CANNOT
                      else flight.ended_by)
    said = ['']

    def progress(words: str) -> None:
        if words != said[0]:                    # it is looked at several times a second
            said[0] = words
            page.tell('progress', name, words)
    flight = fly.Flight(scenario, run_dir, domain, headless, stop_asked, console=True, known=known,
                        progress=progress)
    code = flight.fly()
    if code == EXIT_INTERRUPTED and not stopped:
        raise KeyboardInterrupt
    return code
