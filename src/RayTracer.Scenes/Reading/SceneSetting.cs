namespace RayTracer.Scenes;

/// <summary>
/// A value to put in the place of one of a scene file, written <c>camera.fieldOfView=35</c>. Elements of lists are told by their numbers from 0
/// (<c>shapes[2].radius=1</c>) or by their names (<c>shapes.globe.radius=1</c>); names with other signs than letters, digits, - and _ stand in brackets and double quotes.
/// The value is JSON; a word without quotes is a string.
/// </summary>
public sealed class SceneSetting
{
    private SceneSetting(string text, IReadOnlyList<SettingStep> steps, int valueStart)
    {
        Text = text;
        Steps = steps;
        ValueStart = valueStart;
    }

    /// <summary>Path and value, as they were written.</summary>
    public string Text { get; }

    /// <summary>The path, as it was written.</summary>
    public string Path => Text[..(ValueStart - 1)];

    /// <summary>The value, as it was written.</summary>
    public string Value => Text[ValueStart..];

    internal IReadOnlyList<SettingStep> Steps { get; }

    internal int ValueStart { get; }

    /// <summary>Reads path and value.</summary>
    /// <param name="text">The text.</param>
    /// <exception cref="FormatException">It has no path, or no =; the message says what was expected.</exception>
    public static SceneSetting Parse(string text)
    {
        List<SettingStep> steps = [];
        int at = 0;
        while (true)
        {
            SettingStep step = at < text.Length && text[at] == '[' ? Bracket(text, at) : Key(text, at);
            steps.Add(step);
            at = step.End;
            switch (at < text.Length ? text[at] : '\0')
            {
                case '=':
                    return new(text, steps, at + 1);
                case '.':
                    at++;
                    break;
                case '[':
                    break;
                default:
                    throw Expected(at, "\"=\" and a value", text);
            }
        }
    }

    private static SettingStep Key(string text, int start)
    {
        int end = start;
        while (end < text.Length && text[end] is not ('.' or '[' or ']' or '=' or '"'))
        {
            end++;
        }

        return end > start ? new(text[start..end], null, start, end) : throw Expected(start, "a key", text);
    }

    private static SettingStep Bracket(string text, int start)
    {
        bool isQuoted = start + 1 < text.Length && text[start + 1] == '"';
        int end = text.IndexOf(isQuoted ? "\"]" : "]", start + 1, StringComparison.Ordinal);
        if (end < 0)
        {
            throw Expected(text.Length, "\"]\"", text);
        }

        string key = text[(start + (isQuoted ? 2 : 1))..end];
        return isQuoted ? new(key, null, start, end + 2)
            : int.TryParse(key, System.Globalization.NumberStyles.None, null, out int index) ? new(key, index, start, end + 1)
            : throw Expected(start + 1, "the number of an element from 0, or a name in double quotes,", text);
    }

    private static FormatException Expected(int at, string what, string text) =>
        new($"expected {what} at column {at + 1}, but found {(at < text.Length ? Quotation.Of(text[at..(at + 1)]) : "the end")}: settings are written PATH=VALUE, as in camera.fieldOfView=35");
}
