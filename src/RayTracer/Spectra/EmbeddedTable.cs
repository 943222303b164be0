namespace RayTracer.Spectra;

/// <summary>Reads tables of data that are embedded in an assembly: words between blanks, line by line.</summary>
internal static class EmbeddedTable
{
    /// <summary>The words of each line.</summary>
    /// <param name="owner">A type of the assembly.</param>
    /// <param name="name">The name of the table.</param>
    public static string[][] Read(Type owner, string name)
    {
        using StreamReader reader = new(owner.Assembly.GetManifestResourceStream(name)!);
        return [.. reader.ReadToEnd().Split('\n', StringSplitOptions.RemoveEmptyEntries).Select(line => line.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries))];
    }
}
