using System.Text;

namespace RayTracer.Jobs;

/// <summary>Writes commands as they are typed into a POSIX shell.</summary>
public static class Shell
{
    /// <summary>The command <c>raytracer</c> with words after it, in quotes where a shell needs them.</summary>
    public static string Command(IEnumerable<string> words) => string.Join(' ', words.Select(Quote).Prepend("raytracer"));

    /// <summary>The words of a command that <see cref="Command"/> wrote.</summary>
    public static string[] Words(string command)
    {
        List<string> words = [];
        StringBuilder word = new();
        bool isQuoted = false;
        bool isWord = false;
        for (int i = 0; i < command.Length; i++)
        {
            char c = command[i];
            if (c == '\'')
            {
                isQuoted = !isQuoted;
                isWord = true;
            }
            else if (c == ' ' && !isQuoted)
            {
                Finish();
            }
            else
            {
                // Outside of quotes, Command writes a backslash only before the character that it stands for.
                word.Append(c == '\\' && !isQuoted && i + 1 < command.Length ? command[++i] : c);
                isWord = true;
            }
        }

        Finish();
        return [.. words];

        void Finish()
        {
            if (isWord)
            {
                words.Add(word.ToString());
            }

            word.Clear();
            isWord = false;
        }
    }

    private static string Quote(string word) =>
        word.Length > 0 && word.All(c => char.IsLetterOrDigit(c) || "-_./,:=+@%".Contains(c, StringComparison.Ordinal))
            ? word
            : $"'{word.Replace("'", "'\\''", StringComparison.Ordinal)}'";
}
