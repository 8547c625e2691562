export { PatternWindow as PatternPane } from "../pattern/PatternWindow";
