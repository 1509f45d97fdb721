/** A result's dataset as `haptonic.views.packed` writes it. */

export type Numbers = Float64Array | Float32Array | Int32Array | Int16Array | Int8Array;

interface Described {
  dims: string[];
  shape: number[];
  attrs: Record<string, string>;
  texts?: string[];
  type?: "<f8" | "<f4" | "<i4" | "<i2" | "|i1";
  start?: number;
  scale?: number;
}

export interface Header {
  kind: string;
  title: string;
  extra: Record<string, unknown>;
  attrs: Record<string, string | number>;
  variables: Record<string, Described>;
}

/** Content that zlib has compressed. */
export async function inflated(content: Uint8Array<ArrayBuffer>): Promise<ArrayBuffer> {
  const stream = new Blob([content]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).arrayBuffer();
}

const ALIGNED = 8;
const READERS = {
  "<f8": Float64Array,
  "<f4": Float32Array,
  "<i4": Int32Array,
  "<i2": Int16Array,
  "|i1": Int8Array,
} as const;

export class Dataset {
  private constructor(
    readonly header: Header,
    private readonly content: ArrayBuffer,
    private readonly front: number,
  ) {}

  static read(content: ArrayBuffer): Dataset {
    const length = new DataView(content).getUint32(0, true);
    const text = new TextDecoder().decode(new Uint8Array(content, 4, length));
    const front = Math.ceil((4 + length) / ALIGNED) * ALIGNED;
    return new Dataset(JSON.parse(text) as Header, content, front);
  }

  has(name: string): boolean {
    return name in this.header.variables;
  }

  /** Values in C order; those of 16 bits are not scaled, see `scale`. */
  values(name: string): Numbers {
    const { type, start, shape } = this.described(name);
    if (type === undefined || start === undefined) throw new Error(`${name} has no numbers`);
    const count = shape.reduce((a, b) => a * b, 1);
    return new READERS[type](this.content, this.front + start, count);
  }

  scale(name: string): number {
    return this.described(name).scale ?? 1;
  }

  texts(name: string): string[] {
    return this.described(name).texts ?? [];
  }

  shape(name: string): number[] {
    return this.described(name).shape;
  }

  /** The unit of a variable, and its title. */
  unit(name: string): string {
    return this.described(name).attrs["units"] ?? "";
  }

  title(name: string): string {
    return this.described(name).attrs["long_name"] ?? name;
  }

  /** An attribute of the dataset that contains JSON. */
  parsed<T>(name: string): T {
    return JSON.parse(String(this.header.attrs[name])) as T;
  }

  private described(name: string): Described {
    const found = this.header.variables[name];
    if (found === undefined) throw new Error(`the dataset has no variable ${name}`);
    return found;
  }
}
