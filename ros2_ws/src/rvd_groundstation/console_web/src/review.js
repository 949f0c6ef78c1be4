export class Review {
  constructor() { this.on = false; }
  list() {}
}
