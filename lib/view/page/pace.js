// How finely a moving model is drawn, so that it keeps up with the hand: found out from what pictures take.

// From the finest on: pixels of a picture for one of the page, along each direction, and cells of the mesh that are told
// apart. The first is the picture at rest; only it is antialiased, which costs a renderer without a graphics card most.
const details = [{ share: 1 }, { share: 0.5 }, { share: 0.5, cells: 8000 }, { share: 1 / 3, cells: 3000 },
  { share: 0.25, cells: 1500 }];

class Pace {
  constructor() {
    this.costs = []; // milliseconds, as last measured
    this.maxCost = 50; // leaves the browser as much again, for ten pictures a second
    this.lowCost = 12; // below it a finer picture is tried
    this.begin();
  }

  get isQuick() { return !(this.costs[0] > this.maxCost); }
  get detail() { return details[this.level]; }

  // A movement begins with what is known to be quick enough; with the third where nothing is known.
  begin() {
    const quick = details.findIndex((_, k) => this.costs[k] <= this.maxCost);
    this.level = quick >= 0 ? quick : this.costs[2] === undefined ? 2 : details.length - 1;
    this.finest = this.isQuick || !this.isSure ? 0 : 1;
  }

  // What was too slow is not tried again in the same movement.
  tell(cost) {
    this.costs[this.level] = cost;
    if (cost > this.maxCost) this.finest = this.level = Math.min(this.level + (cost > 4 * this.maxCost ? 2 : 1), details.length - 1);
    else if (cost < this.lowCost && this.level > this.finest) --this.level;
  }

  // The first picture takes longer than others, as everything is sent to the graphics card for it.
  tellAtRest(cost) {
    this.isSure = this.costs[0] !== undefined;
    this.costs[0] = cost;
  }
}
