// What the linear march allows: nowhere is fractionOf steeper than 2/pi, so a cone narrower by epsilon pi/2 keeps the
// error.
//
// dark  below -1 + 1.4 epsilon^(2/3) the fraction is less than epsilon: 4 sqrt(2) / (3 pi) (1 + r)^(3/2) near -1. (The
//       source's text stops where the nearest is above 0 but for epsilon: at half shadow.)
float narrower(float nearest) { return nearest - 1.57079632679490 * frame.coneError; }
bool dark(float nearest) { return nearest <= -1.0 + 1.4 * pow(frame.coneError, 2.0 / 3.0); }
