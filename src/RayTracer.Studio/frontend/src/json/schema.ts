/** What a JSON schema (the part of it that the scene format's schema uses) says about a place of a document. */

export interface Schema {
  $ref?: string;
  $defs?: Record<string, Schema>;
  type?: string | string[];
  enum?: unknown[];
  const?: unknown;
  properties?: Record<string, Schema>;
  additionalProperties?: boolean | Schema;
  required?: string[];
  items?: Schema;
  anyOf?: Schema[];
  oneOf?: Schema[];
  description?: string;
  default?: unknown;
}

type Data = Record<string | number, unknown> | undefined;

export class SchemaGuide {
  constructor(private readonly root: Schema) {}

  /** The schemas that may describe the value at a path; a fixed word such as "type" that the document holds decides between them. */
  at(path: readonly (string | number)[], document: unknown): Schema[] {
    let schemas = this.alternatives(this.root, document);
    let value = document;
    for (const key of path) {
      value = (value as Data)?.[key];
      schemas = schemas.flatMap((s) => this.child(s, key)).flatMap((s) => this.alternatives(s, value));
    }
    return schemas;
  }

  /** The members that an object at a path may have. */
  members(path: readonly (string | number)[], document: unknown): Map<string, Schema> {
    const result = new Map<string, Schema>();
    for (const s of this.at(path, document)) {
      for (const [key, member] of Object.entries(s.properties ?? {})) if (!result.has(key)) result.set(key, this.resolve(member));
    }
    return result;
  }

  /** The words that may stand at a path. */
  values(path: readonly (string | number)[], document: unknown): unknown[] {
    // Without the present value, which must not narrow what may replace it.
    const parent = path.slice(0, -1);
    const last = path.at(-1);
    const data = last === undefined ? undefined : without(document, path);
    const found = last === undefined ? this.alternatives(this.root, undefined) : this.at(parent, data).flatMap((s) => this.child(s, last)).flatMap((s) => this.alternatives(s, undefined));
    return [...new Set(found.flatMap((s) => (s.const !== undefined ? [s.const] : s.enum ?? (s.type === "boolean" ? [true, false] : []))))];
  }

  private child(schema: Schema, key: string | number): Schema[] {
    if (typeof key === "number") return schema.items ? [schema.items] : [];
    const own = schema.properties?.[key];
    if (own) return [own];
    return typeof schema.additionalProperties === "object" ? [schema.additionalProperties] : [];
  }

  private resolve(schema: Schema): Schema {
    if (!schema.$ref) return schema;
    let target: unknown = this.root;
    for (const key of schema.$ref.replace(/^#\/?/, "").split("/")) target = (target as Data)?.[key.replaceAll("~1", "/").replaceAll("~0", "~")];
    return { ...(target as Schema), ...(schema.description ? { description: schema.description } : {}) };
  }

  private alternatives(given: Schema, value: unknown): Schema[] {
    const schema = this.resolve(given);
    const choices = schema.anyOf ?? schema.oneOf;
    if (!choices) return [schema];
    const { anyOf: _, oneOf: __, ...own } = schema;
    const all = choices.flatMap((c) => this.alternatives(c, value)).map((s) => ({ ...own, ...s, properties: { ...own.properties, ...s.properties } }));
    return this.narrowed(all, value);
  }

  private narrowed(all: Schema[], value: unknown): Schema[] {
    if (typeof value !== "object" || value === null) return all;
    const fits = all.filter((s) => Object.entries(s.properties ?? {}).some(([key, p]) => p.const !== undefined && (value as Data)![key] === p.const));
    return fits.length ? fits : all;
  }
}

function without(document: unknown, path: readonly (string | number)[]): unknown {
  const [first, ...rest] = path;
  if (first === undefined || typeof document !== "object" || document === null) return undefined;
  const copy = (Array.isArray(document) ? [...(document as unknown[])] : { ...document }) as Record<string | number, unknown>;
  if (rest.length) copy[first] = without(copy[first], rest);
  else delete copy[first];
  return copy;
}
