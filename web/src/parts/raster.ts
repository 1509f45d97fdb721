/** An image of few pixels that fills a canvas, which is as wide as its parent. */

const TALLEST = 0.62; // of the window

export class Raster {
  readonly image: ImageData;

  private constructor(
    private readonly canvas: HTMLCanvasElement,
    readonly context: CanvasRenderingContext2D,
    private readonly small: OffscreenCanvas,
    private readonly inner: OffscreenCanvasRenderingContext2D,
  ) {
    this.image = new ImageData(small.width, small.height);
  }

  /** Null if the browser gives no context. */
  static on(canvas: HTMLCanvasElement, columns: number, rows: number): Raster | null {
    const small = new OffscreenCanvas(columns, rows);
    const [context, inner] = [canvas.getContext("2d"), small.getContext("2d")];
    return context === null || inner === null ? null : new Raster(canvas, context, small, inner);
  }

  /** Draw the image over the whole canvas; without smoothing its pixels stay apart. */
  show(smooth: boolean): void {
    const { canvas, context } = this;
    this.inner.putImageData(this.image, 0, 0);
    context.clearRect(0, 0, canvas.width, canvas.height);
    context.imageSmoothingEnabled = smooth;
    context.imageSmoothingQuality = "high";
    context.drawImage(this.small, 0, 0, canvas.width, canvas.height);
  }

  /** Fit the canvas into its parent with a ratio of height to width, now and later; returns what ends it. */
  follow(ratio: number, draw: () => void): () => void {
    const { canvas } = this;
    const fit = () => {
      const width = Math.min(canvas.parentElement?.clientWidth ?? 300, (TALLEST * innerHeight) / ratio);
      canvas.style.width = `${width}px`;
      canvas.style.height = `${width * ratio}px`;
      canvas.width = Math.round(width * devicePixelRatio);
      canvas.height = Math.round(width * ratio * devicePixelRatio);
      draw();
    };
    const resized = new ResizeObserver(fit);
    if (canvas.parentElement !== null) resized.observe(canvas.parentElement);
    return () => resized.disconnect();
  }
}
