using System.Reflection;

namespace RayTracer.Labs;

/// <summary>A lab, as this program carries it.</summary>
/// <param name="Number">Its number, from 1.</param>
/// <param name="Name">The name of its folder, which begins with the number.</param>
public sealed record Lab(int Number, string Name)
{
    private const string Prefix = "labs/";

    /// <summary>All labs, in their order.</summary>
    public static IReadOnlyList<Lab> All { get; } =
    [
        .. Carried.GetManifestResourceNames().Where(n => n.StartsWith(Prefix, StringComparison.Ordinal))
            .Select(n => n.Split('/')[1]).Distinct().Select(n => new Lab(int.Parse(n.Split('-')[0]), n)).OrderBy(l => l.Number),
    ];

    /// <summary>What it is about: the heading of the handout.</summary>
    public string Title => Text(Files("handout.md").Single()).Split('\n')[0].TrimStart('#', ' ');

    private static Assembly Carried => typeof(Lab).Assembly;

    /// <summary>The lab of a number.</summary>
    /// <param name="number">The number.</param>
    /// <exception cref="LabException">There is none.</exception>
    public static Lab Of(int number) => All.FirstOrDefault(l => l.Number == number)
        ?? throw new LabException($"there is no lab {number}: there are {string.Join(", ", All.Select(l => l.Number))}");

    /// <summary>The paths of its files below a folder, from the lab's own folder.</summary>
    /// <param name="below">The folder, or the file.</param>
    internal IEnumerable<string> Files(string below)
    {
        string own = $"{Prefix}{Name}/";
        return Carried.GetManifestResourceNames().Where(n => n.StartsWith(own + below, StringComparison.Ordinal)).Select(n => n[own.Length..]).Order(StringComparer.Ordinal);
    }

    /// <summary>Opens a file.</summary>
    /// <param name="path">Its path from the lab's own folder.</param>
    internal Stream Open(string path) => Carried.GetManifestResourceStream($"{Prefix}{Name}/{path}")!;

    /// <summary>The text of a file.</summary>
    /// <param name="path">Its path from the lab's own folder.</param>
    internal string Text(string path)
    {
        using StreamReader reader = new(Open(path));
        return reader.ReadToEnd().ReplaceLineEndings("\n");
    }
}
