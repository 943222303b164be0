namespace RayTracer.Jobs;

/// <summary>
/// Since when kinds of things have the bits that they have: films of a scene with one of them go together only if they were rendered with the same version. A version is the number of the change
/// in <c>hashes.txt</c>, the list of the films' hashes, by which the bits became others.
/// </summary>
public static class BitVersions
{
    private static readonly Dictionary<string, int> s_versions = new(StringComparer.Ordinal)
    {
    };

    /// <summary>The kinds that have changed since films were first written.</summary>
    public static IReadOnlyDictionary<string, int> Changes => s_versions;

    /// <summary>The version of a kind.</summary>
    /// <param name="kind">The name of a type as scenes write it, or of a choice as it is called in C#.</param>
    public static int Of(string kind) => s_versions.GetValueOrDefault(kind, 1);
}
