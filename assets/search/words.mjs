/* How scores are told. */

/** A chance in percent, or another score as it is. @param {number} score @param {boolean} chances */
export const scoreWords = (score, chances) => {
  if (!chances) return score.toFixed(3);
  if (score < 0.01) return "< 1 %";
  return score >= 0.995 && score < 0.9999 ? "> 99 %" : `${Math.round(100 * score)} %`;
};
