// The field of view of the camera on board: a lens with fixed steps, so that what comes nearer
// looms; each step is twice as wide as the one before.

const SLACK = 0.9; // a narrower step is taken only once it shows that much less than all of it

export function stepsOf([least, most]) {
  const steps = [least];
  while (steps[steps.length - 1] < most) steps.push(Math.min(2 * steps[steps.length - 1], most));
  return steps;
}

// The tangent of half the field at a range; `before` is the one that has been in use.
export function fieldOf({ half_field: field, half_height_m: height }, range, before) {
  const steps = stepsOf(field);
  const wanted = height / range;
  const least = steps.findIndex((step) => step >= wanted);
  const i = least < 0 ? steps.length - 1 : least;
  return before === steps[i + 1] && wanted > SLACK * steps[i] ? before : steps[i];
}

export const degrees = (tan) => (2 * Math.atan(tan) * 180) / Math.PI;
