# The object in the cache has another number in it; the code is made again.
python3 - "$XDG_CACHE_HOME"/symreal/*.file <<'PYTHON' || exit 1
import struct, sys
count = 0
for path in sys.argv[1:]:
    data = open(path, "rb").read()
    changed = data.replace(struct.pack("<d", 2.5), struct.pack("<d", 3.5))
    count += changed != data
    open(path, "wb").write(changed)
sys.exit(count == 0)
PYTHON
"$1" generate damaged.c -o k.c
