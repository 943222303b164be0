using System.Globalization;
using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Scenes;

namespace RayTracer.Import;

/// <summary>A parameter of a thing: "float radius" 2.</summary>
/// <param name="Type">Its type: float, rgb, texture and so on.</param>
/// <param name="Name">Its name.</param>
/// <param name="Place">Its place.</param>
/// <param name="Numbers">Its values, where they are numbers.</param>
/// <param name="Words">Its values, where they are texts, or true and false.</param>
internal sealed record PbrtParameter(string Type, string Name, SourcePlace Place, IReadOnlyList<float> Numbers, IReadOnlyList<string> Words);

/// <summary>
/// A thing of a scene (a shape, a material, a light and so on) with its parameters. Each reading of a parameter marks it as known; what nobody has asked for
/// is an error in the end, so that nothing is passed over silently.
/// </summary>
/// <param name="kind">What it is, as messages call it.</param>
/// <param name="type">The type within its kind.</param>
/// <param name="place">The place of its directive.</param>
/// <param name="typePlace">The place of its type.</param>
/// <param name="state">What held where it stands: transform, material and so on.</param>
/// <param name="files">The places of files.</param>
/// <param name="log">Takes what is wrong.</param>
internal sealed class PbrtThing(string kind, string type, SourcePlace place, SourcePlace typePlace, PbrtState state, PbrtFiles files, ImportLog log)
{
    private readonly Dictionary<string, PbrtParameter> _parameters = new(StringComparer.Ordinal);
    private readonly HashSet<string> _asked = new(StringComparer.Ordinal);
    private readonly HashSet<string> _inherited = new(StringComparer.Ordinal);
    private bool _isFinished;

    /// <summary>What it is: shape, material, light and so on.</summary>
    public string Kind => kind;

    /// <summary>The type within its kind.</summary>
    public string Type => type;

    /// <summary>The place of its directive.</summary>
    public SourcePlace Place => place;

    /// <summary>What held where it stands.</summary>
    public PbrtState State { get; private set; } = state;

    /// <summary>Takes what is wrong with it.</summary>
    public ImportLog Log => log;

    /// <summary>Its places while it moves, none of which counts for it from then on: it is made where it would be without.</summary>
    public PbrtPlaces TakePlaces()
    {
        PbrtPlaces places = State.Places;
        State = State with { Places = PbrtPlaces.World };
        return places;
    }

    /// <summary>Adds a parameter.</summary>
    public void Add(PbrtParameter parameter)
    {
        if (!_parameters.TryAdd(parameter.Name, parameter))
        {
            log.Error(parameter.Place, $"{Quotation.Of(parameter.Name)} is given twice");
        }
    }

    /// <summary>Adds what an Attribute directive gives all things of a kind, unless the thing says something else.</summary>
    public void Inherit(PbrtParameter parameter)
    {
        if (_parameters.TryAdd(parameter.Name, parameter))
        {
            _inherited.Add(parameter.Name);
        }
    }

    /// <summary>True where a parameter is given.</summary>
    public bool Has(string name) => _parameters.ContainsKey(name);

    /// <summary>The place of a parameter; that of the thing where it is not given.</summary>
    public SourcePlace PlaceOf(string name) => _parameters.TryGetValue(name, out PbrtParameter? parameter) ? parameter.Place : place;

    /// <summary>A parameter; null where it is not given.</summary>
    public PbrtParameter? Parameter(string name)
    {
        _asked.Add(name);
        return _parameters.GetValueOrDefault(name);
    }

    /// <summary>Takes parameters as known that change nothing here.</summary>
    public void Ignore(params ReadOnlySpan<string> names)
    {
        foreach (string name in names)
        {
            _asked.Add(name);
        }
    }

    /// <summary>A number.</summary>
    /// <param name="name">The parameter.</param>
    /// <param name="standard">The value where none is given.</param>
    /// <param name="minimum">The least that is allowed.</param>
    /// <param name="maximum">The most that is allowed.</param>
    public float Float(string name, float standard, float minimum = float.NegativeInfinity, float maximum = float.PositiveInfinity) =>
        Numbers(name, "float", 1) is [var value] && IsWithin(name, value, minimum, maximum) ? value : standard;

    /// <summary>A whole number.</summary>
    public int Integer(string name, int standard, int minimum = int.MinValue) =>
        Numbers(name, "integer", 1) is [var value] && IsWithin(name, value, minimum, float.PositiveInfinity) ? (int)float.Min(value, 1 << 30) : standard;

    /// <summary>A point or vector; null where it is not given.</summary>
    public Vector3? Vector(string name, string kindOfVector) => Numbers(name, kindOfVector, 3) is [var x, var y, var z] ? new(x, y, z) : null;

    /// <summary>Points, vectors or normals; empty where they are not given.</summary>
    public Vector3[] Vectors(string name, string kindOfVector) =>
        Numbers(name, kindOfVector, 0) is { } v && IsMultiple(name, v.Count, 3) ? [.. Enumerable.Range(0, v.Count / 3).Select(i => new Vector3(v[3 * i], v[(3 * i) + 1], v[(3 * i) + 2]))] : [];

    /// <summary>Pairs of numbers; empty where they are not given.</summary>
    public Vector2[] Pairs(string name) =>
        Numbers(name, "point2", 0) is { } v && IsMultiple(name, v.Count, 2) ? [.. Enumerable.Range(0, v.Count / 2).Select(i => new Vector2(v[2 * i], v[(2 * i) + 1]))] : [];

    /// <summary>Whole numbers; empty where they are not given.</summary>
    public int[] Integers(string name) => Numbers(name, "integer", 0) is { } v ? [.. v.Select(i => (int)float.Clamp(i, -1, 1 << 30))] : [];

    /// <summary>Numbers; empty where they are not given.</summary>
    public IReadOnlyList<float> Floats(string name) => Numbers(name, "float", 0) ?? [];

    /// <summary>True where something holds.</summary>
    public bool Boolean(string name, bool standard)
    {
        if (Parameter(name) is not { } parameter || !Is(parameter, "bool"))
        {
            return standard;
        }

        if (parameter.Words is ["true" or "false"])
        {
            return parameter.Words[0] == "true";
        }

        return log.Fail<bool?>(parameter.Place, $"expected true or false for {Quotation.Of(name)}") ?? standard;
    }

    /// <summary>A text; null where it is not given.</summary>
    public string? Text(string name) => Parameter(name) is not { } parameter || !Is(parameter, "string") ? null
        : parameter.Words is [var word] ? word : log.Fail<string>(parameter.Place, $"expected one string for {Quotation.Of(name)}");

    /// <summary>One of several words.</summary>
    /// <param name="name">The parameter.</param>
    /// <param name="standard">The value where none is given.</param>
    /// <param name="words">The words and what they mean.</param>
    public T Choice<T>(string name, T standard, IReadOnlyDictionary<string, T> words)
    {
        if (Text(name) is not { } text)
        {
            return standard;
        }

        if (words.TryGetValue(text, out T? choice))
        {
            return choice;
        }

        string message = $"{Quotation.Of(text)} is not a value that {Quotation.Of(name)} may have here{ImportLog.Hint(text, [.. words.Keys])}";
        log.Unsupported(PlaceOf(name), message, "the default is used instead");
        return standard;
    }

    /// <summary>The file that a parameter names, as the scene's folder sees it; null, with an error, where it is not given.</summary>
    public string? FileName(string name = "filename") => Text(name) is { Length: > 0 } text ? files.Find(text)
        : log.Fail<string>(PlaceOf(name), $"{Describe()} needs {Quotation.Of(name)}, the path of a file");

    /// <summary>The path of a file that is read at once.</summary>
    public string PathOf(string name) => files.Resolve(name);

    /// <summary>Says that a parameter is not supported, where it is given.</summary>
    public void Refuse(string name, string why, string standIn = "it is ignored")
    {
        if (Parameter(name) is { } parameter)
        {
            log.Unsupported(parameter.Place, why, standIn);
        }
    }

    /// <summary>Says what nobody has asked for.</summary>
    public void Finish()
    {
        if (_isFinished)
        {
            return;
        }

        _isFinished = true;
        foreach ((string name, PbrtParameter parameter) in _parameters.Where(p => !_asked.Contains(p.Key) && !_inherited.Contains(p.Key)))
        {
            string hint = ImportLog.Hint(name, [.. _asked.Order(StringComparer.Ordinal)]);
            log.Unsupported(parameter.Place, $"{Describe()} has no parameter {Quotation.Of(name)} here{hint}", "it is ignored");
        }
    }

    /// <summary>Says that its type is none of those that are supported.</summary>
    public void UnknownType(IReadOnlyCollection<string> known)
    {
        string message = $"{PbrtPlugins.PluralOf(kind)} of type {Quotation.Of(type)} are not supported";
        string end = PbrtPlugins.Refused.GetValueOrDefault((kind, type)) is { } reason ? $": {reason}" : ImportLog.Hint(type, known);
        log.Unsupported(typePlace, message + end, PbrtPlugins.StandInOf(kind));

        // Its parameters say nothing to a stand-in.
        _isFinished = true;
    }

    /// <summary>The name in messages.</summary>
    public string Describe() => type.Length > 0 ? $"{kind} {Quotation.Of(type)}" : kind;

    /// <summary>Returns true where a parameter is of a type; reports an error otherwise.</summary>
    public bool Is(PbrtParameter parameter, params ReadOnlySpan<string> types)
    {
        bool isExpected = types.Contains(parameter.Type);
        if (!isExpected)
        {
            log.Error(parameter.Place, $"{Quotation.Of(parameter.Name)} must be of type {string.Join(" or ", types.ToArray())}, not {parameter.Type}");
        }

        return isExpected;
    }

    private bool IsWithin(string name, float value, float minimum, float maximum)
    {
        bool isWithin = value >= minimum && value <= maximum;
        if (!isWithin)
        {
            string range = float.IsInfinity(maximum) ? $"at least {minimum}" : $"from {minimum} to {maximum}";
            log.Error(PlaceOf(name), string.Create(CultureInfo.InvariantCulture, $"{Quotation.Of(name)} must be {range}, but it is {value}"));
        }

        return isWithin;
    }

    private bool IsMultiple(string name, int count, int of)
    {
        if (count % of != 0)
        {
            log.Error(PlaceOf(name), $"{Quotation.Of(name)} needs a multiple of {of} numbers, but has {count}");
        }

        return count % of == 0;
    }

    // As many numbers as wanted, or any number where that is 0; null where they are not given, or after an error.
    private IReadOnlyList<float>? Numbers(string name, string wantedType, int count)
    {
        if (Parameter(name) is not { } parameter || !Is(parameter, wantedType))
        {
            return null;
        }

        if (count > 0 && parameter.Numbers.Count != count)
        {
            return log.Fail<IReadOnlyList<float>>(parameter.Place, $"expected {count} {(count == 1 ? "number" : "numbers")} for {Quotation.Of(name)}, but found {parameter.Numbers.Count}");
        }

        return parameter.Numbers;
    }
}

/// <summary>The places of files that a scene names, and those within it: all from the folder of the scene itself.</summary>
/// <param name="home">The folder.</param>
internal sealed class PbrtFiles(string home)
{
    /// <summary>The path of a file that is read at once.</summary>
    public string Resolve(string name) => Path.Combine(home, name.Replace('\\', '/'));

    /// <summary>The path of a file as the scene's folder sees it.</summary>
    public string Find(string name) => name.Replace('\\', '/');
}
