using System.Text;
using System.Text.RegularExpressions;
using RayTracer.Description;

namespace RayTracer.Scenes;

/// <summary>Says in words what a part of scene files means, from the description records.</summary>
public static partial class SceneExplanation
{
    private const int Indent = 2;

    /// <summary>The topics that can be explained, with the contents of each part.</summary>
    public static string Topics()
    {
        StringBuilder text = new("A scene file has these keys:\n");
        AddKeys(text, SceneTypes.Scene);
        foreach (TypeFamily family in SceneTypes.Families)
        {
            text.Append($"\n{char.ToUpperInvariant(family.Noun[0])}{family.Noun[1..]}s: {string.Join(", ", family.Names)}\n");
        }

        IEnumerable<string> parts = SceneTypes.Parts.Where(p => p != SceneTypes.Scene).Select(p => p.Name).Distinct(StringComparer.Ordinal);
        return text.Append($"\nParts: {string.Join(", ", parts)}\n\nEach of these words and its parts can be explained: camera.fieldOfView, sphere.radius, materials.glass.refractiveIndex\n").ToString();
    }

    /// <summary>Explains a key, a type, or a path of them.</summary>
    /// <param name="topic">As in a setting: <c>camera.fieldOfView</c>, <c>sphere</c>, <c>materials.glass.color</c>.</param>
    /// <exception cref="FormatException">There is nothing of that name; the message has the nearest that there is.</exception>
    public static string Of(string topic)
    {
        string[] words = [.. Elements().Replace(topic, "").Split('.')];
        List<ExplainedPlace> places = First(words[0], isLast: words.Length == 1);
        for (int i = 1; i < words.Length; i++)
        {
            places = Next(places, words[i], string.Join('.', words.Take(i)), isLast: i == words.Length - 1);
        }

        return string.Join("\n", places.Select(p => Text(p, topic)));
    }

    // A key of the scene, a type, a family, or, by itself, a key of anything.
    private static List<ExplainedPlace> First(string word, bool isLast)
    {
        List<ExplainedPlace> places = [];
        if (SceneTypes.Scene.Find(word) is { } parameter)
        {
            places.Add(Place(word, parameter));
        }

        foreach (TypeFamily family in SceneTypes.Families)
        {
            if (family.Find(word) is { } type)
            {
                places.Add(new($"{word} ({family.Noun})", null, [type], false));
            }
            else if (word == family.Noun || (word == $"{family.Noun}s" && places.Count == 0))
            {
                places.Add(new(word, null, family.Types, false));
            }
        }

        if (places.Count == 0)
        {
            places.AddRange(SceneTypes.Parts.Where(p => p.Name == word).Select(p => new ExplainedPlace(word, null, [p], false)));
        }

        IEnumerable<RecordType> all = SceneTypes.Parts.Concat(SceneTypes.Families.SelectMany(f => f.Types));
        if (places.Count == 0 && isLast)
        {
            places.AddRange(Merged(all.Select(t => (Type: t, Parameter: t.Find(word))).Where(p => p.Parameter is not null).Select(p => Place($"{p.Type.Name}.{word}", p.Parameter!))));
        }

        return places.Count > 0 ? places : throw new FormatException($"nothing is called {Quotation.Of(word)}{Spelling.DidYouMean(word, all.Select(t => t.Name)
            .Concat(SceneTypes.Families.SelectMany(f => new[] { f.Noun, $"{f.Noun}s" })).Concat(all.SelectMany(t => t.Parameters).Select(p => p.Key)).Distinct(StringComparer.Ordinal))}");
    }

    private static List<ExplainedPlace> Next(List<ExplainedPlace> places, string word, string before, bool isLast)
    {
        List<ExplainedPlace> next = [];
        foreach (ExplainedPlace place in places)
        {
            if (place.Types.FirstOrDefault(t => t.Name == word && t.Summary.Length > 0) is { } type)
            {
                next.Add(new($"{place.Path}.{word}", null, [type], false));
                continue;
            }

            bool isKey = place.Types.Any(t => t.Find(word) is not null);
            if (isKey)
            {
                next.AddRange(place.Types.Where(t => t.Find(word) is not null)
                    .Select(t => Place(place.Types.Count == 1 ? $"{place.Path}.{word}" : $"{t.Name}.{word}", t.Find(word)!)));
            }

            if (place.HasNames && !(isKey && isLast))
            {
                // A name that a scene gives.
                next.Add(place with { Path = $"{place.Path}.{word}", Parameter = null, HasNames = false });
            }
        }

        if (next.Count > 0)
        {
            return [.. Merged(next)];
        }

        string[] known = [.. places.SelectMany(p => p.Types).SelectMany(t => t.Parameters).Select(p => p.Key).Distinct(StringComparer.Ordinal)];
        throw new FormatException(known.Length == 0 ? $"{Quotation.Of(before)} has no parts"
            : $"there is no {Quotation.Of(word)} in {Quotation.Of(before)}{(Spelling.DidYouMean(word, known) is { Length: > 0 } hint ? hint : $": there are {string.Join(", ", known)}")}");
    }

    private static ExplainedPlace Place(string path, RecordParameter parameter) => new(path, parameter, Within(parameter), parameter.HoldsRecords);

    // The same parameter of several types once, under all of their names.
    private static IEnumerable<ExplainedPlace> Merged(IEnumerable<ExplainedPlace> places) => places
        .GroupBy(p => p.Parameter is { } q ? (q.Summary, q.Unit, q.Range, ParameterForm.Of(q).Words(q), SceneReference.Default(q)) : (p.Path, "", "", "", ""))
        .Select(g => g.First() with { Path = string.Join(", ", g.Select(p => p.Path).Distinct(StringComparer.Ordinal)) });

    private static IReadOnlyList<RecordType> Within(RecordParameter parameter) =>
        parameter.RecordType is { } record ? [RecordType.Of(record)] : parameter.Family?.Types ?? [];

    private static string Text(ExplainedPlace place, string topic)
    {
        StringBuilder text = new($"{place.Path}\n");
        if (place.Parameter is { } parameter)
        {
            AddParameter(text, parameter);
        }
        else if (place.Types is [{ Summary.Length: > 0 } only])
        {
            text.Append($"  {Plain(only.Summary)}\n");
        }

        if (place.Types is [var type])
        {
            text.Append(place.Parameter is null ? "" : $"\n{type.Name}:\n");
            AddKeys(text, type);
        }
        else if (place.Types.Count > 1 && place.Parameter is null)
        {
            string name = topic[(topic.LastIndexOf('.') + 1)..];
            string hint = topic.Contains('.', StringComparison.Ordinal) ? Spelling.DidYouMean(name, place.Types.Select(t => t.Name)) : "";
            text.Append($"  {(hint.Length > 0 ? $"A name of a scene's own{hint}. O" : "O")}ne of these types:\n");
            AddTable(text, place.Types.Select(t => (t.Name, Plain(t.Summary))));
        }

        return text.ToString();
    }

    private static void AddParameter(StringBuilder text, RecordParameter parameter)
    {
        text.Append($"  {Plain(parameter.Summary)}\n");
        foreach ((string name, string value) in new[]
        {
            ("value", Plain(ParameterForm.Of(parameter).Words(parameter))), ("unit", parameter.Unit), ("range", parameter.Range), ("default", Plain(SceneReference.Default(parameter))),
        }.Where(p => p.Item2.Length > 0))
        {
            text.Append($"  {name,-8} {value}\n");
        }
    }

    private static void AddKeys(StringBuilder text, RecordType type) => AddTable(text, type.Parameters.Select(p => (p.Key, Plain(p.Summary))));

    private static void AddTable(StringBuilder text, IEnumerable<(string Word, string Meaning)> rows)
    {
        (string Word, string Meaning)[] all = [.. rows];
        int width = all.Length == 0 ? 0 : all.Max(r => r.Word.Length);
        foreach ((string word, string meaning) in all)
        {
            text.Append($"{new string(' ', Indent)}{word.PadRight(width)}  {meaning}\n");
        }
    }

    // Without the signs of Markdown.
    private static string Plain(string markdown) => Links().Replace(markdown, "$1").Replace("`", "", StringComparison.Ordinal).Replace("**", "", StringComparison.Ordinal);

    [GeneratedRegex(@"\[([^\]]+)\]\([^)]*\)", RegexOptions.None, matchTimeoutMilliseconds: 1000)]
    private static partial Regex Links();

    [GeneratedRegex(@"\[[0-9]*\]", RegexOptions.None, matchTimeoutMilliseconds: 1000)]
    private static partial Regex Elements();
}

/// <summary>A place in scene files, as <see cref="SceneExplanation"/> finds it.</summary>
/// <param name="Path">The path as it is written.</param>
/// <param name="Parameter">The parameter that stands there; null where it is a type.</param>
/// <param name="Types">The types of things that may stand there, or in its elements.</param>
/// <param name="HasNames">True where a name or number comes before their keys.</param>
internal sealed record ExplainedPlace(string Path, RecordParameter? Parameter, IReadOnlyList<RecordType> Types, bool HasNames);
