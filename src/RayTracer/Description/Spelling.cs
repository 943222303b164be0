
namespace RayTracer.Description;

/// <summary>Finds what somebody probably meant to write.</summary>
internal static class Spelling
{
    // Distances take the product of the lengths: beyond these limits a hostile file would take minutes.
    private const int LongestWord = 64;
    public const int MostCandidates = 10_000;

    // Words that many write and that no distance finds.
    private static readonly Dictionary<string, string> Aliases = new(StringComparer.OrdinalIgnoreCase)
    {
        ["centre"] = "center",
        ["colour"] = "color",
        ["albedo"] = "color",
        ["fov"] = "fieldOfView",
        ["spp"] = "samplesPerPixel",
        ["samples"] = "samplesPerPixel",
        ["ior"] = "refractiveIndex",
        ["eye"] = "position",
        ["origin"] = "position",
        ["target"] = "lookAt",
        ["path"] = "file",
        ["objects"] = "shapes",
        ["r"] = "radius",
    };

    /// <summary><c> (did you mean "…"?)</c>, or nothing where no candidate is near.</summary>
    public static string DidYouMean(string word, IEnumerable<string> candidates) =>
        Nearest(word, candidates) is { } nearest ? $" (did you mean {Quotation.Of(nearest)}?)" : "";

    /// <summary>The candidate that is nearest to a word, if any is near.</summary>
    public static string? Nearest(string word, IEnumerable<string> candidates)
    {
        if (word.Length > LongestWord)
        {
            return null;
        }

        Aliases.TryGetValue(word, out string? alias);
        string? nearest = null;
        int least = Math.Max(1, word.Length / 3) + 1;
        foreach (string candidate in candidates.Take(MostCandidates))
        {
            if (candidate == alias || candidate.Equals(word, StringComparison.OrdinalIgnoreCase))
            {
                return candidate;
            }

            // The distance is at least the difference in length.
            if (Math.Abs(candidate.Length - word.Length) < least && EditDistance.Between(word, candidate) is var distance && distance < least)
            {
                least = distance;
                nearest = candidate;
            }
        }

        return nearest;
    }
}
