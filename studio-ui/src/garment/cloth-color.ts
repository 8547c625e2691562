/** The cloth's colour where nothing was chosen and nothing named. */
export const DEFAULT_CLOTH = "#8fa9bd";
