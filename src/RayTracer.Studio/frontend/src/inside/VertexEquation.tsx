import type { InspectedFactor, InspectedLight, InspectedVertex, InspectedWay } from "../api/types";
import { format } from "../json/numbers";
import { select } from "../state/edits";
import { texts } from "../texts";
import { rgb } from "./format";
import { pointedLight } from "./paths";

const t = texts.paths;

/** A factor of a product: its value over its name. */
function Factor({ name, value, tip }: { name: string; value: string; tip?: string | undefined }) {
  return <span class="factor" data-tip={tip}><span class="figures">{value}</span><small>{name}</small></span>;
}

function Product({ factors, over, result }: { factors: [string, string, string?][]; over?: [string, string, string?] | undefined; result: string }) {
  return (
    <div class="product">
      {factors.map(([name, value, tip], i) => <span key={name}>{i > 0 && " · "}<Factor name={name} value={value} tip={tip} /></span>)}
      {over && <span> / <Factor name={over[0]} value={over[1]} tip={over[2]} /></span>}
      <span> = <strong class="figures">{result}</strong></span>
    </div>
  );
}

const isWhite = (c: readonly number[]) => c.every((v) => v === 1);
const carried = ({ throughput, dispersion }: InspectedVertex) => throughput.map((v, i) => v * dispersion[i]!);

function LightRow({ vertex, light, index }: { vertex: InspectedVertex; light: InspectedLight; index: number }) {
  const arrives = light.outcome === "arrives";
  return (
    <li class={`${arrives ? "arrives" : "nothing"} ${pointedLight.value === index ? "pointed" : ""}`} onPointerEnter={() => (pointedLight.value = index)} onPointerLeave={() => (pointedLight.value = -1)}>
      <strong>{light.pointer ? <button type="button" class="link" onClick={() => select(light.pointer)}>{light.name}</button> : light.name}</strong>{" "}
      {!arrives && <span>{light.outcome === "blocked" && light.blocker ? t.blockedBy(light.blocker) : t.outcomes[light.outcome]}</span>}
      {arrives && (
        <Product
          factors={[
            [t.throughput, rgb(carried(vertex))], [t.came, rgb(light.radiance)], [t.bsdf, rgb(light.bsdf)], [t.cosine, format(light.cosine, 3)],
            ...(isWhite(light.transmittance) ? [] : [[t.left, rgb(light.transmittance)] as [string, string]]), [t.share, format(light.weight, 3)],
          ]}
          over={[t.pdfOfLight, format(light.pdf, 3)]}
          result={rgb(light.contribution)}
        />
      )}
      {arrives && light.scatterPdf !== null && <p class="quiet">{t.shares(format(light.weight, 3), format(1 - light.weight, 3), format(light.pdf, 3), format(light.scatterPdf, 3))}</p>}
    </li>
  );
}

/** The light of a path of two parts as an equation. */
export function WayEquation({ way }: { way: InspectedWay }) {
  const written = ({ kind, value }: InspectedFactor): [string, string, string] =>
    [t.factors[kind], value.every((v) => v === value[0]) ? format(value[0]!, 3) : rgb(value), t.factorsWhy[kind]];
  const over = way.factors.find((f) => f.divides);
  return (
    <div class="equation">
      <p>{t.eventsWhy[way.event]}</p>
      {way.factors.length > 0 && <Product factors={[...way.factors.filter((f) => !f.divides).map(written), [t.share, format(way.weight, 3)]]} over={over && written(over)} result={rgb(way.radiance)} />}
    </div>
  );
}

/** What happens at a vertex, as equations with numbers. */
export function VertexEquation({ vertex }: { vertex: InspectedVertex }) {
  const { emission, parts } = vertex;
  const isChosen = vertex.event === "diffuse" && vertex.bsdf !== null && vertex.pdf !== null;
  return (
    <div class="equation">
      <p>{t.eventsWhy[vertex.event]}{vertex.end && `: ${t.ends[vertex.end]}`}</p>
      {!isWhite(vertex.passed) && <p>{t.passed(rgb(vertex.passed))}</p>}
      {!isWhite(vertex.dispersion) && <p>{t.dispersed(rgb(vertex.dispersion))}</p>}
      {emission && (
        <>
          <h4>{t.meets(emission.name)}</h4>
          <Product factors={[[t.throughput, rgb(vertex.throughput)], [t.came, rgb(emission.radiance)], [t.share, format(emission.weight, 3)]]} result={rgb(parts.emitted)} />
          {emission.lightPdf !== null && emission.scatterPdf !== null && <p class="quiet">{t.shares(format(1 - emission.weight, 3), format(emission.weight, 3), format(emission.lightPdf, 3), format(emission.scatterPdf, 3))}</p>}
          {emission.weight === 0 && <p class="quiet">{t.counted}</p>}
        </>
      )}
      {parts.ambient.some((v) => v !== 0) && <p>{t.ambient} <strong class="figures">{rgb(parts.ambient)}</strong></p>}
      {vertex.lights.length > 0 && <h4>{t.asks}</h4>}
      {vertex.event === "specular" && vertex.lights.length === 0 && <p class="quiet">{t.asksNone}</p>}
      <ul>{vertex.lights.map((light, i) => <LightRow vertex={vertex} light={light} index={i} key={i} />)}</ul>
      {vertex.event !== "camera" && vertex.event !== "miss" && vertex.event !== "absorbed" && (
        <>
          <h4>{t.next}</h4>
          {isChosen ? (
            <Product factors={[[t.bsdf, rgb(vertex.bsdf!)], [t.cosine, format(vertex.cosine, 3)]]} over={["pdf", format(vertex.pdf!, 3)]} result={rgb(vertex.weight)} />
          ) : (
            <p>{t.weight} <strong class="figures">{rgb(vertex.weight)}</strong>{vertex.pdf === null ? ` (${t.delta})` : ` (pdf ${format(vertex.pdf, 3)})`}</p>
          )}
          {vertex.survival !== 1 && <p>{t.survived(format(vertex.survival, 3))}</p>}
        </>
      )}
    </div>
  );
}
