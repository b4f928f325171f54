# qm-view: a page for a document of any kind. What needs a browser is skipped where there is none.

load helpers.bash

setup_file() {
    load helpers.bash
    stage surfaces block >/dev/null
}

KINDS=(basecomplex features cut enumeration layout surfaces)

# A test that needs a browser ends here where there is none.
needs_browser() { [[ $browser ]] || skip 'there is no Chromium'; }

# seen PAGE: how many items of each layer a headless Chromium sees, as JSON; fails if the page complains in any way.
seen() {
    local root=()
    ((EUID != 0)) || root=(--no-sandbox)
    timeout 120 "$browser" --headless "${root[@]}" --use-angle=swiftshader --enable-unsafe-swiftshader --window-size="${window_size:-600,420}" \
        --user-data-dir="$PWD/profile" --virtual-time-budget="${virtual_time:-5000}" --enable-logging=stderr --v=0 \
        --dump-dom "file://$PWD/$1#census" >dom 2>log
    # What the graphics driver says about reading pixels back is no fault of the page.
    ! grep CONSOLE log | grep -v 'GL Driver Message' || return 1
    grep -q '<output id="status"[^>]*>ready</output>' dom || return 1
    grep -oP 'data-census="\K[^"]*' dom | sed 's/&quot;/"/g'
}

@test "a page for every kind of document, in one file that asks nothing of the network" {
    for kind in "${KINDS[@]}"; do
        quietly qm-view "$(stage "$kind" block)" -o page.html
        assert_equal "$(head -n 1 page.html)" '<!doctype html>'
        assert_equal "$(tail -n 1 page.html)" '</html>'
        run grep -cE '<(script|img|iframe|link)[^>]+(src|href)="?(https?:)?//' page.html
        assert_output 0
    done
}

@test "the same bytes every time, by name and by pipe" {
    qm-view "$(stage surfaces block)" >one
    qm-view --jobs 1 "$(stage surfaces block)" >two
    assert_same_bytes one two
    qm-view --mesh "$(sample block)" <"$(stage surfaces block)" >three
    assert_same_bytes one three
}

# shows KIND LAYER...: the page of a document of this kind shows something of each layer at first.
shows() {
    qm-view "$(stage "$1" block)" >page.html
    census=$(seen page.html)
    for layer in "${@:2}"; do
        assert_equal "$1, $layer: $(jq --arg layer "$layer" '.[$layer] > 0' <<<"$census")" "$1, $layer: true"
    done
}

@test "the layers of every kind are seen: up to the cut" {
    needs_browser
    shows basecomplex mesh separatrices extraordinary
    shows features mesh separatrices extraordinary
    shows cut submeshes separatrices extraordinary
}

@test "the layers of every kind are seen: from the search on" {
    needs_browser
    shows enumeration submeshes graphs extraordinary
    shows layout segments borders extraordinary
    shows surfaces deviation curves
}

@test "--show switches layers, and looking from the other side shows other items" {
    needs_browser
    qm-view --show segments,tracks "$(stage layout block)" >page.html
    assert_equal "$(seen page.html | jq -c 'keys')" '["segments","tracks"]'
    for view in 0,0,1 0,0,-1; do
        qm-view --show extraordinary,mesh --view "$view" "$(stage layout block)" >page.html
        seen page.html | jq .extraordinary
    done >counts
    qm-view --show extraordinary "$(stage layout block)" >page.html
    assert_equal "$(seen page.html | jq .extraordinary)" "$(field '.baseComplex.extraordinaryVertices | length' "$(stage layout block)")"
    while read -r count; do assert [ "$count" -gt 0 ]; done <counts
}

@test "pointing, finding and keys work" {
    needs_browser
    qm-view "$(stage layout block)" >page.html
    cat >>page.html <<'EOF'
<script>
const canvas = document.getElementById('canvas');
const box = canvas.getBoundingClientRect();
const at = { clientX: box.left + box.width / 2, clientY: box.top + box.height / 2, bubbles: true };
const press = (key) => canvas.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true }));
const tip = () => document.getElementById('tip').textContent;
let frames = 200; // a busy machine takes some until there is something to point at
const untilTipped = () => {
  if (tip() || --frames == 0) return tipped();
  canvas.dispatchEvent(new PointerEvent('pointermove', at));
  requestAnimationFrame(untilTipped);
};
untilTipped();
function tipped() {
  const say = (name, value) => { document.body.dataset[name] = value; };
  say('tip', tip());
  document.getElementById('wanted').value = 'separatrix 3';
  document.getElementById('find').requestSubmit();
  say('info', document.querySelector('#info code').textContent);
  document.getElementById('wanted').value = 'separatrix 999999';
  document.getElementById('find').requestSubmit();
  say('found', document.getElementById('found').textContent);
  ['ArrowLeft', 'ArrowUp', '+', '-', 'x', 'y', 'z', '0', 't'].forEach(press);
  say('transparent', document.getElementById('transparent').checked);
}
</script>
EOF
    seen page.html >census
    grep -qE 'data-tip="[^"]*(segment|side|edge|extraordinary)' dom
    grep -q 'data-info="/baseComplex/separatrices/3"' dom
    grep -q 'data-found="There is no separatrix 999999' dom
    grep -q 'data-transparent="true"' dom
}

@test "a view stays when the key takes more room, and finding goes where the found is" {
    needs_browser
    # Frames by the clock: a headless browser draws few where nothing changes.
    cat >frames <<'EOF'
<script>
let resized;
window.requestAnimationFrame = (draw) => setTimeout(draw, 16);
window.ResizeObserver = class { constructor(call) { resized = call; } observe() {} };
</script>
EOF
    qm-view --show segments "$(stage layout cube)" | sed '/^<body>/r frames' >page.html
    cat >>page.html <<'EOF'
<script>
const canvas = document.getElementById('canvas'), tip = document.getElementById('tip');
const rest = () => new Promise((done) => setTimeout(done, 700));
// What is in the middle of the picture, not on a border.
async function middle() {
  await rest();
  const box = canvas.getBoundingClientRect();
  canvas.dispatchEvent(new PointerEvent('pointermove', { clientX: box.left + box.width / 2 + 2, clientY: box.top + box.height / 2 + 1, bubbles: true }));
  await rest();
  return tip.hidden ? 'nothing' : tip.querySelector('h2').textContent;
}
async function takeRoom(height) {
  document.getElementById('key').style.minHeight = height;
  resized();
  await rest();
}
function find(text) {
  document.getElementById('wanted').value = text;
  document.getElementById('find').requestSubmit();
}
(async () => {
  const seen = [await middle()];
  for (const go of [() => document.querySelector('[data-view=z]').click(), () => find('face 338')]) {
    await takeRoom('');
    go();
    seen.push(await middle());
    await takeRoom('9rem');
    seen.push(await middle());
  }
  document.body.dataset.seen = seen.join();
})();
</script>
EOF
    virtual_time=20000 seen page.html >census
    IFS=, read -ra middles < <(grep -oP 'data-seen="\K[^"]*' dom)
    assert [ "${middles[0]}" != "${middles[1]}" ]
    assert_equal "${middles[2]}" "${middles[1]}"
    assert_equal "${middles[4]}" "${middles[3]}"
}

@test "all text stands out from what is behind it, light and dark" {
    needs_browser
    qm-view "$(stage surfaces block)" >page.html
    cat >>page.html <<'EOF'
<script>
const numbers = (colour) => colour.match(/[\d.]+/g).map(Number);
const linear = (part) => (part <= 10 ? part / 3294.6 : ((part / 255 + 0.055) / 1.055) ** 2.4);
const light = ([red, green, blue]) => 0.2126 * linear(red) + 0.7152 * linear(green) + 0.0722 * linear(blue) + 0.05;
function behind(node) {
  const colour = numbers(getComputedStyle(node).backgroundColor);
  return colour.length < 4 || colour[3] > 0.5 ? colour : behind(node.parentElement);
}
document.getElementById('wanted').value = 'separatrix 999999';
document.getElementById('find').requestSubmit();
const faint = [];
for (const theme of ['light', 'dark']) {
  document.documentElement.dataset.theme = theme;
  const test = (node, style) => {
    const [less, more] = [light(numbers(style.color)), light(behind(node))].sort((a, b) => a - b);
    if (more / less < 4.5) faint.push(`${theme} ${node.tagName}#${node.id}`);
  };
  const wanted = document.getElementById('wanted');
  test(wanted, getComputedStyle(wanted, '::placeholder'));
  for (const node of document.querySelectorAll('#stage *, #panel *'))
    if ([...node.childNodes].some((child) => child.nodeType === Node.TEXT_NODE && child.textContent.trim())) test(node, getComputedStyle(node));
}
document.body.dataset.faint = faint.join();
</script>
EOF
    seen page.html >census
    grep -q 'data-faint=""' dom
}

@test "--png takes a picture of the size that was asked for, and writes no page unless told" {
    needs_browser
    quietly qm-view "$(stage layout block)" --png block.png --size 320x240
    assert_equal "$output" ''
    # Width and height stand at byte 16 of a PNG file.
    assert_equal "$(od -An -tu1 -j16 -N8 block.png | xargs)" '0 0 1 64 0 0 0 240'
    quietly qm-view "$(stage layout block)" --png mesh.png --size 320x240 --show mesh -o mesh.html
    assert [ -s mesh.html ]
    run cmp -s block.png mesh.png
    assert_failure
    # The key is left out of a picture, never of a page.
    quietly qm-view "$(stage layout block)" --png keyless.png --size 320x240 --no-key -o keyless.html
    run cmp -s block.png keyless.png
    assert_failure
    qm-view "$(stage layout block)" >page.html
    assert_same_bytes keyless.html page.html
}

@test "pictures are taken wherever temporary files go" {
    needs_browser
    qm-view "$(stage layout block)" --png usual.png --size 320x240
    mkdir 'a#b c%20?d'
    for folder in "$PWD/a#b c%20?d" .; do
        TMPDIR=$folder quietly qm-view "$(stage layout block)" --png other.png --size 320x240
        assert_same_bytes usual.png other.png
    done
    assert_equal "$(ls -A 'a#b c%20?d')" ''
    TMPDIR=$PWD/missing complains qm-view "$(stage layout block)" --png other.png
    assert_regex "$stderr" 'no temporary folder can be made. Set TMPDIR'
}

@test "a small picture has room for the whole key" {
    needs_browser
    local window_size
    qm-view --show tolerance,jumps,curves "$(stage surfaces block)" >page.html
    echo "<script>document.body.classList.add('still'); const key = document.getElementById('key');
        document.body.dataset.key = [key.scrollHeight > key.clientHeight, key.getBoundingClientRect().bottom > innerHeight];</script>" >>page.html
    for window_size in 400,300 390,844 1200,900; do
        seen page.html >census
        assert_equal "$window_size: $(grep -oP 'data-key="\K[^"]*' dom)" "$window_size: false,false"
    done
}

@test "without a browser --png says what to install, and writes nothing" {
    mkdir bare
    run --separate-stderr env PATH="$PWD/bare" "$QM_BIN/qm-view" "$(stage layout block)" --png block.png
    assert_complaint qm-view
    assert_regex "$stderr" 'chromium'
    assert [ ! -e block.png ]
}

@test "where a picture cannot be written, no page is, either" {
    complains qm-view "$(stage layout block)" --png missing/part.png -o part.html
    assert_regex "$stderr" 'there is no folder missing'
    assert [ ! -e part.html ]
}

@test "bad options are usage errors, missing layers are named" {
    misused qm-view --png block.png --size 10 "$(stage layout block)"
    misused qm-view --png block.png --size 5x5 "$(stage layout block)"
    misused qm-view --size 300x300 "$(stage layout block)"
    misused qm-view --no-key "$(stage layout block)"
    misused qm-view --view 0,0,0 "$(stage layout block)"
    misused qm-view --show no-such-layer "$(stage layout block)"
    misused qm-view --up 1,2 "$(stage layout block)"
    misused qm-view --png same -o same "$(stage layout block)"
    complains qm-view --show segments "$(stage cut block)"
    assert_regex "$stderr" 'no layer segments'
    complains qm-view --show mesh,segments "$(stage layout block)"
    assert_regex "$stderr" 'both colour the faces'
}

@test "surfaces are seen as the page evaluates them from control points and knots" {
    needs_browser
    local layer
    for layer in zebra gauss tolerance; do
        qm-view --show "$layer,curves,jumps,net,knots" "$(stage surfaces block)" >page.html
        assert_equal "$layer: $(seen page.html | jq ".$layer > 0 and .net > 0 and .knots > 0 and .jumps > 0")" "$layer: true"
    done
}

@test "every layer can be switched to, and none fails" {
    needs_browser
    qm-view "$(stage surfaces cube)" >page.html
    cat >>page.html <<'END'
<script>
const inputs = [...document.querySelectorAll('#layers input')].filter((input) => input.value !== 'on');
for (const input of inputs) if (!input.checked) input.click();
document.body.dataset.switched = inputs.map((input) => input.value).join(' ');
document.body.dataset.scales = document.querySelectorAll('.scale').length;
document.getElementById('theme').click();
document.body.dataset.theme = document.documentElement.dataset.theme;
// The key has grown: the picture has the pixels of what is left for it.
const canvas = document.getElementById('canvas');
let frames = 200; // a busy machine takes some
const untilItFits = () => {
  document.body.dataset.fits = canvas.width === canvas.clientWidth && canvas.height === canvas.clientHeight;
  if (document.body.dataset.fits === 'false' && --frames > 0) requestAnimationFrame(untilItFits);
};
untilItFits();
</script>
END
    virtual_time=60000 seen page.html >census
    for layer in shaded zebra mesh-zebra mean gauss deviation tolerance jumps net knots; do
        grep -qE "data-switched=\"([^\"]* )?${layer}[ \"]" dom
    done
    # The last layer of faces, which tells what is within the tolerance, and the normal angles have a scale each.
    grep -q 'data-scales="2"' dom
    grep -q 'data-theme="dark"' dom
    grep -q 'data-fits="true"' dom
}

@test "the page evaluates surfaces and curvatures truly" {
    needs_browser
    qm-shape torus -o torus.obj
    qm-basecomplex torus.obj | qm-features -q | qm-enum -q | qm-merge -q | qm-bspline -q -o torus.json
    qm-view --show mean torus.json >page.html
    echo "<script>document.body.dataset.note = document.querySelector('.note').textContent;</script>" >>page.html
    seen page.html >census
    # The mean curvature of a torus of radii R and r is largest where it is widest.
    expected=$(awk '/^v / { d = sqrt($2 * $2 + $3 * $3); if (d > widest) widest = d; if (!narrowest || d < narrowest) narrowest = d }
        END { R = (widest + narrowest) / 2; r = (widest - narrowest) / 2; print (R + 2 * r) / (2 * r * (R + r)) }' torus.obj)
    largest=$(grep -oP 'data-note="largest \K[0-9.]+' dom)
    assert_equal "$(jq -n "$largest / $expected | . > 0.95 and . < 1.2")" true
}

# drags MICROSECONDS: as JSON, what a drag by the mouse draws with a graphics card, simulated, that takes so long for a
# vertex: of every picture its vertices and its width as a share of the page's.
drags() {
    cat >simulation <<END
<script>
let clock = 0, vertices = 0;
performance.now = () => clock;
for (const { prototype } of [WebGLRenderingContext, WebGL2RenderingContext])
  for (const [name, place] of [['drawElements', 1], ['drawArrays', 2]]) {
    const draw = prototype[name];
    prototype[name] = function (...of) { vertices += of[place]; clock += of[place] * $1 / 1000; return draw.apply(this, of); };
  }
</script>
END
    qm-view "$(stage surfaces block)" | sed '/^<body>/r simulation' >page.html
    cat >>page.html <<'END'
<script>
const canvas = document.getElementById('canvas'), seen = [];
const mouse = (type, where, x) => where.dispatchEvent(new MouseEvent(type, { clientX: x, clientY: 200, button: 0, bubbles: true }));
const look = (what) => { if (vertices) seen.push([what, vertices, canvas.width / canvas.clientWidth]); vertices = 0; };
look('first');
mouse('mousedown', canvas, 200);
let x = 200;
const drag = () => {
  look('turning');
  if (seen.length > 12) return mouse('mouseup', document, x), rest();
  mouse('mousemove', document, x += 5);
  requestAnimationFrame(drag);
};
drag();
function rest() {
  if (vertices === 0) return setTimeout(rest, 100);
  look('rest');
  document.body.dataset.seen = JSON.stringify(seen);
}
</script>
END
    virtual_time=60000 seen page.html >census
    grep -oP 'data-seen="\K[^"]*' dom | sed 's/&quot;/"/g'
}

@test "while it turns, the model is drawn as coarsely as the machine needs, and fully at rest" {
    needs_browser
    # A million vertices take a second, or a millisecond.
    drags 1 >slow
    jq -e 'last as $rest | [.[] | select(.[0] == "turning")] as $turning | ($turning | length) > 10 and
        ($turning | all(.[1] < $rest[1] / 4 and .[2] < 0.51)) and $rest[0] == "rest" and $rest[2] == 1' slow
    drags 0.001 >quick
    jq -e 'last as $rest | [.[] | select(.[0] == "turning")] as $turning | ($turning | length) > 10 and
        ($turning | all(.[1] >= $rest[1] and .[2] == 1)) and $rest[0] == "rest" and $rest[2] == 1' quick
}

@test "a scale of curvatures is for the usual bends, not for planes, and not for one outlier" {
    needs_browser
    {
        echo '<!doctype html><output id="status">ready</output><script>'
        cat "$ROOT/lib/view/page/scale.js"
        cat <<'END'
const values = Float32Array.from({ length: 10000 }, (_, k) => (k === 5 ? 2.5e5 : k < 1000 ? 0.5 : 1e-9));
const tops = [values, values.map(() => 1e-9)].map((some) => scaleTops({ scale: 'centred', source: 'mean curvature', values: some }, 2));
document.body.dataset.census = JSON.stringify(tops.map((top) => [top.usual, top.maximum]));
</script>
END
    } >page.html
    assert_equal "$(seen page.html | jq -c '.[0], .[1][0]' | xargs)" '[0.5,250000] 0.0005'
}

@test "figures below a scale do not cover one another, however long they are" {
    needs_browser
    qm-view --show deviation "$(stage surfaces block)" >page.html
    cat >>page.html <<'END'
<script>
const boxes = [...document.querySelectorAll('.ticks')].map((ticks) => [...ticks.children].map((tick) => tick.getBoundingClientRect()));
document.body.dataset.census = JSON.stringify(boxes.map((of) => [of.length, of.every((box, k) => k === 0 || box.left > of[k - 1].right)]));
</script>
END
    assert_equal "$(seen page.html | head -n 1)" '[[3,true]]'
}

@test "a section opens the model" {
    needs_browser
    for section in x:1 x:0.5 x:0; do
        qm-view --show mesh --section "$section" "$(stage layout block)" >page.html
        seen page.html | jq '.mesh // 0'
    done >counts
    mapfile -t counts <counts
    assert [ "${counts[0]}" -gt 0 ]
    assert [ "${counts[1]}" -gt 0 ]
    assert [ "${counts[0]}" != "${counts[1]}" ]
    # What lies in the plane itself stays.
    assert [ "${counts[2]}" -lt "${counts[1]}" ]
    # The page takes the very share, whatever the steps of its slider.
    qm-view --section x:0.0123 "$(stage layout block)" >page.html
    echo "<script>document.body.dataset.share = document.getElementById('section-share').value;</script>" >>page.html
    seen page.html >census
    grep -q 'data-share="0.0123"' dom
    misused qm-view --section a:0.5 "$(stage layout block)"
    misused qm-view --section x:2 "$(stage layout block)"
}

@test "--compare shows two documents side by side, the other one on the left" {
    needs_browser
    qm-view --compare "$(stage layout block)" "$(stage surfaces block)" --show zebra,borders >page.html
    assert_equal "$(seen page.html | jq 'length == 2 and .[0].borders > 0 and .[1].zebra > 0')" true
    quietly qm-view --compare "$(stage layout block)" "$(stage surfaces block)" --png both.png --size 400x200
}

@test "--compare names what is wrong with the other document" {
    complains qm-view --compare nowhere.json "$(stage surfaces block)"
    assert_regex "$stderr" 'nowhere.json'
    complains qm-view --show cuts --compare "$(stage features block)" "$(stage features block)"
    assert_regex "$stderr" 'no layer cuts'
}

@test "--compare warns of keys that look misspelt in the other document, too" {
    jq '.constrants = {}' "$(stage basecomplex block)" >other.json
    captured qm-view "$(stage basecomplex block)" --compare other.json -o page.html
    assert_equal "$status:$stderr" "0:qm-view: other.json: /constrants: no tool reads this key. Is it 'constraints'?"
}

@test "pages are small" {
    qm-view "$(stage surfaces block)" >page.html
    assert [ "$(stat -c %s page.html)" -lt 2000000 ]
}

@test "a document finds its mesh beside itself" {
    mkdir elsewhere made
    cp "$(sample cube)" made/part.obj
    qm-basecomplex made/part.obj -o made/part.json
    mv made/part.obj made/part.json elsewhere
    quietly qm-view elsewhere/part.json -o page.html
    cd elsewhere
    quietly qm-view part.json -o ../page.html
    mv part.obj other.obj
    complains qm-view part.json
    assert_regex "$stderr" '[-]-mesh'
}

@test "lengths are told in the unit of the mesh" {
    qm-view --unit cm "$(stage surfaces block)" >page.html
    grep -q '"unit":"cm","limit"' page.html
    misused qm-view --unit furlong "$(stage surfaces block)"
}
