using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;

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
        string way = Way(vertices, brightest, isMet: emitted >= Math.Max(ambient, direct));
        if (emitted >= Math.Max(ambient, direct))
        {
            string met = at.Event == "miss" ? "Light of the surroundings" : $"Light of {Named(at.Emission?.Name ?? at.Name)}";
            return way.Length == 0 ? $"{met} was seen directly." : $"{met} {way}{(IsByChance(vertices, brightest, integrator) ? "; paths find it by chance only, so this pixel is noisy." : ".")}";
        }

        if (ambient > direct)
        {
            return $"Ambient light {way}.";
        }

        InspectedLight? light = at.Lights.MaxBy(l => l.Contribution.Luminance);
        return light is { Contribution.IsBlack: false } ? $"Light of {Named(light.Name)} {way}." : $"Paths from the lights were joined with this path: their light {way}.";
    }

    /// <summary>Whether a path met a light that nothing else looks for.</summary>
    /// <param name="vertices">The vertices of the path.</param>
    /// <param name="met">The place of the one where the light is met.</param>
    /// <param name="integrator">The integrator.</param>
    public static bool IsByChance(IReadOnlyList<InspectedVertex> vertices, int met, Integrator integrator) =>
        !integrator.Has(IntegratorTraits.TracesLight) && vertices.Take(met).Any(v => v.Event == "diffuse")
        && (vertices[met].Emission is { ScatterPdf: null } || vertices[met].Event == "miss");

    // From the light to the camera.
    private static string Way(IReadOnlyList<InspectedVertex> vertices, int from, bool isMet)
    {
        List<(string Verb, List<string> Things)> steps = [];
        for (int i = isMet ? from - 1 : from; i > 0; i--)
        {
            InspectedVertex v = vertices[i];
            bool goesOn = isMet || i < from;
            bool passes = goesOn && v.Normal is { } normal && Vector3.Dot(vertices[i + 1].Position - v.Position, normal) < 0;
            string verb = v.Name == "medium" ? "was scattered by" : passes ? "came through" : goesOn && v.Event == "specular" ? "was mirrored by" : "was reflected by";
            string thing = v.Name == "medium" ? "the medium" : Named(v.Name);
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
}
