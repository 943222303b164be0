using System.Globalization;

namespace RayTracer.Jobs;

/// <summary>What a command says about a picture besides its content (<see cref="ContentHash.OfPicture"/>): how it looks, what comes with it, and when it is good enough.</summary>
internal static class PictureOptions
{
    // With what they are where they are not given; null where that is something else than any value.
    private static readonly Dictionary<string, string?> WithValue = new(StringComparer.Ordinal)
    {
        ["--exposure"] = "0",
        ["--tonemap"] = "clamp",
        ["--bit-depth"] = "8",
        ["--quality"] = "90",
        ["--chroma"] = null,
        ["--aov"] = null,
        ["--noise"] = null,
        ["--samples"] = null,
        ["--time"] = null,
    };

    private static readonly string[] WithoutValue = ["--denoise", "--adaptive", "--exr-film"];

    /// <summary>Whether two commands say the same. Scene, files to write, and all options that the content tells do not count.</summary>
    public static bool AreSame(string command, string other) => Of(command).SetEquals(Of(other));

    private static HashSet<(string Option, string Value)> Of(string command)
    {
        string[] words = Shell.Words(command);
        Dictionary<string, string> options = new(StringComparer.Ordinal);
        for (int i = 0; i < words.Length; i++)
        {
            if (WithoutValue.Contains(words[i]))
            {
                options[words[i]] = "";
            }
            else if (WithValue.ContainsKey(words[i]) && i + 1 < words.Length)
            {
                string option = words[i++];
                options[option] = Plain(words[i]);
            }
        }

        return [.. options.Where(o => WithValue.GetValueOrDefault(o.Key) != o.Value).Select(o => (o.Key, o.Value))];
    }

    private static string Plain(string value) =>
        double.TryParse(value, NumberStyles.Float, CultureInfo.InvariantCulture, out double number) ? number.ToString(CultureInfo.InvariantCulture) : value;
}
