// Whether the side "Walk" is chosen: a click on a box or an arrow of the graph is then a step of the walk.

export const walking = { on: false };
