export function drawViews() { return []; }
