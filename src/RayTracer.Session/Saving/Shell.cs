namespace RayTracer.Session;

/// <summary>Writes commands as they are typed into a POSIX shell.</summary>
public static class Shell
{
    /// <summary>The command <c>raytracer</c> with words after it, in quotes where a shell needs them.</summary>
    public static string Command(IEnumerable<string> words) => string.Join(' ', words.Select(Quote).Prepend("raytracer"));

    private static string Quote(string word) =>
        word.Length > 0 && word.All(c => char.IsLetterOrDigit(c) || "-_./,:=+@%".Contains(c, StringComparison.Ordinal))
            ? word
            : $"'{word.Replace("'", "'\\''", StringComparison.Ordinal)}'";
}
