import { Component, type ReactNode } from "react";
import { Button } from "../ui/Button";

interface Props {
  what: string;
  children: ReactNode;
}

/** A part that fails says so in its place; the rest of the studio goes on. */
export class ErrorBoundary extends Component<Props, { error: Error | null }> {
  override state: { error: Error | null } = { error: null };

  static getDerivedStateFromError(error: unknown) {
    return { error: error instanceof Error ? error : new Error(String(error)) };
  }

  override render() {
    const { error } = this.state;
    if (error === null) return this.props.children;
    const webgl = /webgl/i.test(error.message);
    return (
      <div className="failed" role="alert">
        <h2>{this.props.what} cannot be shown</h2>
        <p>{error.message}</p>
        <p className="hint">
          {webgl
            ? "The browser gives no WebGL. Switch on hardware acceleration in its settings, or use another browser."
            : "Your work is kept. Try it again, or load the page again."}
        </p>
        <Button onClick={() => this.setState({ error: null })}>Try again</Button>
      </div>
    );
  }
}
