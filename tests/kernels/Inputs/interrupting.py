#!/usr/bin/env python3
"""The tool, during which the user ends the run."""
import os
import signal
import time

os.kill(os.getppid(), signal.SIGTERM)
time.sleep(600)
