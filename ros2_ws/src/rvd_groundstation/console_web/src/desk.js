export class Desk {
  constructor(link) { this.link = link; }
  show() {}
  lease() {}
}
