import "./styles/theme.css";
import "./styles/controls.css";
import "./styles/layout.css";
import "./styles/prompt.css";
import "./styles/dialogs.css";
import { StrictMode } from "react";
import { createRoot } from "react-dom/client";
import { App } from "./App";
import { boot } from "./actions/boot";
import { remembered } from "./state/remembered";
import { type Theme, useStudio } from "./state/store";
import type { Units } from "./state/units";

const dark = window.matchMedia("(prefers-color-scheme: dark)").matches;
const theme = remembered<Theme>("theme", dark ? "dark" : "light");
document.documentElement.dataset.theme = theme;
useStudio.setState({ theme, units: remembered<Units>("units", "cm") });

const root = document.getElementById("root");
if (root !== null)
  createRoot(root).render(
    <StrictMode>
      <App />
    </StrictMode>,
  );
void boot();
