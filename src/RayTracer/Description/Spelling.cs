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

/// <summary>The distance between two words, on which "did you mean" is based.</summary>
internal static class EditDistance
{
    /// <summary>
    /// The least number of insertions, deletions, changes and swaps of neighbours between two words, where no part is
    /// edited twice (Damerau 1964; optimal string alignment). Takes time and memory in proportion to the product of the lengths.
    /// </summary>
    /// <param name="a">One word.</param>
    /// <param name="b">The other word.</param>
    public static int Between(string a, string b)
    {
        int[,] d = new int[a.Length + 1, b.Length + 1];
        for (int i = 0; i <= a.Length; i++)
        {
            for (int j = 0; j <= b.Length; j++)
            {
                d[i, j] = i == 0 || j == 0 ? i + j : Math.Min(
                    Math.Min(d[i - 1, j], d[i, j - 1]) + 1, d[i - 1, j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1));
                if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                {
                    d[i, j] = Math.Min(d[i, j], d[i - 2, j - 2] + 1);
                }
            }
        }

        return d[a.Length, b.Length];
    }
}
