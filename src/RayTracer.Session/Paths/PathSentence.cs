using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Rendering;

namespace RayTracer.Session;

/// <summary>Says in plain words what happened to a path.</summary>
internal static class PathSentence
{
    private const float Faint = 1e-3f;

    /// <summary>Returns one sentence or two, with the names of things between asterisks.</summary>
    /// <param name="radiance">The light that the path brings.</param>
    /// <param name="vertices">Its vertices, the camera first.</param>
    /// <param name="integrator">The integrator.</param>
    public static string Of(Rgb radiance, IReadOnlyList<InspectedVertex> vertices, Integrator integrator)
    {
        int brightest = Enumerable.Range(0, vertices.Count).MaxBy(i => Luminance(vertices[i].Contribution));
        InspectedVertex at = vertices[brightest];
        if (radiance.Luminance <= 0 || Luminance(at.Contribution) <= 0)
        {
            return Nothing(vertices);
        }

        if (brightest == 0)
        {
            return "Paths from the lights were connected with the lens, and brought light here.";
        }

        (double emitted, double ambient, double direct) = (Luminance(at.Parts.Emitted), Luminance(at.Parts.Ambient), Luminance(at.Parts.Direct));
        InspectedLight? light = at.Lights.MaxBy(l => l.Contribution.Luminance);
        bool isMet = emitted >= Math.Max(ambient, direct);
        Vector3? source = isMet ? at.Position : ambient > direct ? null : light?.Point;
        string way = Way(source, Back(vertices, isMet ? brightest - 1 : brightest, !isMet), vertices[0].Position);
        if (isMet)
        {
            string met = $"Light of {Lamp(at.Emission?.Name ?? at.Name)}";
            return way.Length == 0 ? $"{met} was seen directly." : $"{met} {way}{(IsByChance(vertices, brightest, integrator) ? "; paths find it by chance only, so this pixel is noisy." : ".")}";
        }

        if (ambient > direct)
        {
            return $"Ambient light {way}.";
        }

        return light is { Contribution.IsBlack: false } ? $"Light of {Lamp(light.Name)} {way}." : $"Paths from the lights were joined with this path: their light {way}.";
    }

    /// <summary>Whether a path met a light that nothing else looks for.</summary>
    /// <param name="vertices">The vertices of the path.</param>
    /// <param name="met">The place of the one where the light is met.</param>
    /// <param name="integrator">The integrator.</param>
    public static bool IsByChance(IReadOnlyList<InspectedVertex> vertices, int met, Integrator integrator) =>
        !integrator.Has(IntegratorTraits.TracesLight) && vertices.Take(met).Any(v => v.Event == "diffuse")
        && vertices[met].Emission is { ScatterPdf: null, IsFoundOtherwise: false };

    /// <summary>As <see cref="Of"/>, for the brightest of several ways that are made of a part from a light and one from the camera.</summary>
    /// <param name="way">The way.</param>
    /// <param name="lightPart">The vertices from the light, that on it left out; names beside them.</param>
    /// <param name="vertices">The vertices of the camera's path.</param>
    /// <param name="end">The number of the last one that the way has.</param>
    public static string OfWay(InspectedWay way, IReadOnlyList<(string Name, PathVertex Vertex)> lightPart, IReadOnlyList<InspectedVertex> vertices, int end)
    {
        // Of a merge both last vertices are one, and where the camera's path meets the light, its last vertex is the light.
        IEnumerable<Stop> fromLight = lightPart.Take(lightPart.Count - (way.Event == "merged" ? 1 : 0))
            .Select(v => new Stop(v.Name, v.Vertex.Normal, v.Vertex.Position!.Value, v.Vertex.Event == PathEvent.Specular));
        IEnumerable<Stop> toCamera = Back(vertices, way.Event == "met" ? end - 1 : end, isAsked: way.Event != "met");
        Vector3? from = lightPart.Count > 0 ? lightPart[0].Vertex.Origin : way.Event == "met" ? vertices[end].Position : way.Points[^1];
        string chain = Way(from, [.. fromLight, .. toCamera], vertices[0].Position);
        return chain.Length == 0 ? $"Light of {Lamp(way.Light)} was seen directly." : $"Light of {Lamp(way.Light)} {chain}.";
    }

    // From the light, where its place is known, to the camera.
    private static string Way(Vector3? from, IReadOnlyList<Stop> stops, Vector3 eye)
    {
        List<(string Verb, List<string> Things)> steps = [];
        for (int i = 0; i < stops.Count; i++)
        {
            (string name, Vector3? normal, Vector3 at, bool isSpecular) = stops[i];
            Vector3? before = i > 0 ? stops[i - 1].Position : from;
            Vector3 after = i + 1 < stops.Count ? stops[i + 1].Position : eye;
            bool passes = normal is { } up && before is { } source && Vector3.Dot(source - at, up) * Vector3.Dot(after - at, up) < 0;
            string verb = name == "medium" ? "was scattered by" : passes ? "came through" : isSpecular ? "was mirrored by" : "was reflected by";
            string thing = name == "medium" ? "the medium" : Named(name);
            if (steps.Count == 0 || steps[^1].Verb != verb)
            {
                steps.Add((verb, []));
            }

            if (steps[^1].Things.Count == 0 || steps[^1].Things[^1] != thing)
            {
                steps[^1].Things.Add(thing);
            }
        }

        return Listed([.. steps.Select(s => $"{s.Verb} {Listed(s.Things)}")]);
    }

    // Where the camera's path asks for light, it need not go on as a mirror would: no vertex is one there.
    private static IReadOnlyList<Stop> Back(IReadOnlyList<InspectedVertex> vertices, int from, bool isAsked) =>
        [.. Enumerable.Range(1, Math.Max(0, from)).Reverse().Select(i => Stop.At(vertices[i]) is var stop && isAsked && i == from ? stop with { IsSpecular = false } : stop)];

    private static string Listed(List<string> parts) => parts.Count < 2 ? string.Concat(parts) : $"{string.Join(", ", parts.SkipLast(1))} and {parts[^1]}";

    private static string Nothing(IReadOnlyList<InspectedVertex> vertices)
    {
        InspectedVertex last = vertices[^1];
        string end = last.Event switch
        {
            "miss" => "the path left the scene, where it is dark",
            "absorbed" => $"{Named(last.Name)} let nothing go on",
            "emission" => $"{Named(last.Name)} was met where its light had been counted before",
            _ => last.End switch
            {
                "roulette" => $"chance ended the path at {Named(last.Name)}, as it carried little",
                "gathered" => $"no path from the lights came to {Named(last.Name)}",
                "depth" => $"the path was as long as the scene allows at {Named(last.Name)}",
                _ => $"the path ended at {Named(last.Name)}",
            },
        };
        if (last.Emission is { Weight: <= Faint })
        {
            end = $"the light of {Named(last.Emission.Name)} that was met had been asked for before";
        }

        InspectedLight? blocked = vertices.SelectMany(v => v.Lights).FirstOrDefault(l => l is { Outcome: "blocked", Blocker: not null });
        return blocked is null ? $"No light came: {end}." : $"No light came: {Named(blocked.Blocker!)} is in the way of {Named(blocked.Name)}, and {end}.";
    }

    private static double Luminance(IReadOnlyList<double> c) => (0.2126 * c[0]) + (0.7152 * c[1]) + (0.0722 * c[2]);

    private static string Named(string name) => $"*{name}*";

    private static string Lamp(string name) => name is "surroundings" or "background" ? "the surroundings" : Named(name);

    // Where a path is turned.
    private readonly record struct Stop(string Name, Vector3? Normal, Vector3 Position, bool IsSpecular)
    {
        public static Stop At(InspectedVertex v) => new(v.Name, v.Normal, v.Position, v.Event == "specular");
    }
}
