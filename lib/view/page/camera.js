// Where one looks from, by pointer and by keys.

class View {
  constructor(page, models, canvas, moved) {
    this.from = new THREE.Vector3().fromArray(page.from);
    this.direction = this.from; // that all of the mesh is seen from, whatever the size; null once the view was moved
    this.models = models;
    this.radius = Math.max(...models.map((model) => model.radius));
    this.moved = moved;
    this.camera = new THREE.PerspectiveCamera(24, 1, 0.1, 10);
    this.camera.up.fromArray(page.up).normalize();
    this.controls = new THREE.OrbitControls(this.camera, canvas);
    this.controls.enableKeys = false;
    this.controls.screenSpacePanning = true;
    this.controls.addEventListener('change', moved);
    this.controls.addEventListener('start', () => { this.direction = null; });
    canvas.addEventListener('keydown', (event) => this.key(event));
  }

  resize(width, height) {
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    if (this.direction) this.lookFrom(this.direction);
  }

  // All of the mesh, from a direction, in the middle and as large as it can be.
  lookFrom(direction) {
    this.direction = direction;
    // Never straight along "up", which would leave open what is right.
    const back = direction.clone().normalize().addScaledVector(new THREE.Vector3(0.31, -0.67, 0.53), 1e-4).normalize();
    const right = new THREE.Vector3().crossVectors(this.camera.up, back).normalize();
    const above = new THREE.Vector3().crossVectors(back, right);
    const fill = 0.92;
    const tangent = Math.tan(THREE.Math.degToRad(this.camera.fov / 2)) * fill;
    const axes = [[right, tangent * this.camera.aspect], [above, tangent]];
    this.controls.target.set(0, 0, 0);
    let distance = 0;
    for (let round = 0; round < 3; ++round) { // perspective moves the middle as the distance changes
      const sides = axes.map(([axis, slope]) => this.sides(axis, back, slope));
      distance = Math.max(...sides.map(([low, high]) => (high - low) / 2));
      sides.forEach(([low, high], k) => this.controls.target.addScaledVector(axes[k][0], (high + low) / 2 * axes[k][1]));
    }
    this.camera.position.copy(this.controls.target).addScaledVector(back, Math.max(distance, 1e-3 * this.radius));
    this.controls.update();
    this.moved();
  }

  // How far back the eye must be for the mesh to fit on either side of the target, less and more along an axis.
  sides(axis, back, slope) {
    const target = this.controls.target;
    let low = Infinity, high = -Infinity;
    for (const { mesh: { positions, quads } } of this.models)
      for (const point of quads) { // vertices that no face has are not drawn
        const x = positions[3 * point] - target.x, y = positions[3 * point + 1] - target.y, z = positions[3 * point + 2] - target.z;
        const along = (x * axis.x + y * axis.y + z * axis.z) / slope, nearer = x * back.x + y * back.y + z * back.z;
        high = Math.max(high, along + nearer);
        low = Math.min(low, along - nearer);
      }
    return high >= low ? [low, high] : [0, 0];
  }

  reset() { this.lookFrom(this.from); }

  // Along an axis.
  along(axis) {
    this.lookFrom(new THREE.Vector3(axis === 'x' ? 1 : 0, axis === 'y' ? -1 : 0, axis === 'z' ? 1 : 0));
  }

  // Where the eye is, seen from what it looks at.
  get offset() { return this.camera.position.clone().sub(this.controls.target); }

  standAt(offset) {
    this.direction = null;
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
    this.moved();
  }

  goTo(place) {
    const { offset } = this;
    this.controls.target.copy(place);
    this.standAt(offset);
  }

  turn(right, upwards) {
    const { offset } = this;
    const side = new THREE.Vector3().crossVectors(this.camera.up, offset).normalize();
    const angle = offset.angleTo(this.camera.up);
    offset.applyAxisAngle(side, -Math.min(Math.max(upwards, 0.01 - Math.PI + angle), angle - 0.01));
    this.standAt(offset.applyAxisAngle(this.camera.up, right));
  }

  move(right, upwards) {
    const scale = this.offset.length() * 0.05;
    const step = new THREE.Vector3().setFromMatrixColumn(this.camera.matrix, 0).multiplyScalar(right * scale)
      .addScaledVector(new THREE.Vector3().setFromMatrixColumn(this.camera.matrix, 1), upwards * scale);
    this.goTo(this.controls.target.clone().add(step));
  }

  zoom(factor) { this.standAt(this.offset.multiplyScalar(factor)); }

  key(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    const arrow = arrows[event.key];
    const actions = { '+': () => this.zoom(0.85), '=': () => this.zoom(0.85), '-': () => this.zoom(1 / 0.85), 0: () => this.reset(),
      x: () => this.along('x'), y: () => this.along('y'), z: () => this.along('z') };
    if (arrow && event.shiftKey) this.move(arrow[0], arrow[1]);
    else if (arrow) this.turn(arrow[0] * 0.1, arrow[1] * 0.1);
    else if (actions[event.key.toLowerCase()]) actions[event.key.toLowerCase()]();
    else return;
    event.preventDefault();
  }

  // Depth is kept to what there is, so that it is told apart finely; lifts shrink as one comes near.
  prepare() {
    const distance = this.camera.position.length();
    const radius = 1.5 * this.radius; // control points may lie outside the ball
    this.camera.near = Math.max(distance - radius, 0.002 * radius);
    this.camera.far = distance + radius;
    this.camera.updateProjectionMatrix();
    shared.liftUnit.value = Math.min(0.002 * this.radius / this.camera.position.distanceTo(this.controls.target), 0.02);
  }
}
