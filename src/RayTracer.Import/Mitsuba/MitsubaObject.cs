using System.Globalization;
using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Scenes;

namespace RayTracer.Import;

/// <summary>
/// A thing of a scene (a shape, a BSDF, an emitter and so on) with its properties. Each reading of a property marks it as known;
/// what nobody has asked for is an error in the end, so that nothing is passed over silently.
/// </summary>
/// <param name="element">Its element.</param>
/// <param name="files">The folders in which files that it names are looked for.</param>
/// <param name="log">Takes what is wrong.</param>
internal sealed class MitsubaObject(MitsubaElement element, MitsubaFiles files, ImportLog log)
{
    private readonly Dictionary<string, MitsubaElement> _properties = new(StringComparer.Ordinal);
    private readonly List<MitsubaChild> _children = [];
    private readonly HashSet<string> _asked = new(StringComparer.Ordinal);
    private readonly HashSet<string> _soughtAfter = new(StringComparer.Ordinal);
    private readonly HashSet<MitsubaChild> _taken = [];
    private bool _isFinished;

    /// <summary>The kind: shape, bsdf, emitter and so on.</summary>
    public string Kind => element.Name;

    /// <summary>The type within its kind.</summary>
    public string Type { get; } = element.Attribute("type") ?? "";

    /// <summary>The name by which it is referred to; empty where there is none.</summary>
    public string Id { get; } = element.Attribute("id") ?? "";

    /// <summary>The place in the file.</summary>
    public SourcePlace Place => element.Place;

    /// <summary>The place of its type.</summary>
    public SourcePlace TypePlace => element.PlaceOf("type");

    /// <summary>Takes what is wrong with it.</summary>
    public ImportLog Log => log;

    /// <summary>True where something was asked of it that is referred to and is not there, which has been said.</summary>
    public bool LacksSomething { get; private set; }

    /// <summary>Adds a property.</summary>
    public void Add(string name, MitsubaElement property)
    {
        if (!_properties.TryAdd(name, property))
        {
            log.Error(property.Place, $"{Quotation.Of(name)} is given twice");
        }
    }

    /// <summary>Adds a thing within it.</summary>
    public void Add(MitsubaChild child) => _children.Add(child);

    /// <summary>True where a property is given.</summary>
    public bool Has(string name)
    {
        _soughtAfter.Add(name);
        return _properties.ContainsKey(name);
    }

    /// <summary>The element of a property; null where it is not given.</summary>
    public MitsubaElement? Property(string name)
    {
        _asked.Add(name);
        return _properties.GetValueOrDefault(name);
    }

    /// <summary>The place of a property; that of the object where it is not given.</summary>
    public SourcePlace PlaceOf(string name) => _properties.TryGetValue(name, out MitsubaElement? property) ? property.Place : Place;

    /// <summary>Takes properties as known that change nothing here.</summary>
    public void Ignore(params ReadOnlySpan<string> names)
    {
        foreach (string name in names)
        {
            _asked.Add(name);
        }
    }

    /// <summary>A number.</summary>
    /// <param name="name">The property.</param>
    /// <param name="standard">The value where none is given.</param>
    /// <param name="minimum">The least that is allowed.</param>
    /// <param name="maximum">The most that is allowed.</param>
    public float Float(string name, float standard, float minimum = float.NegativeInfinity, float maximum = float.PositiveInfinity)
    {
        if (Property(name) is not { } property || !Is(property, "a number", "float", "integer") || MitsubaNumbers.Float(property, "value", log) is not { } value)
        {
            return standard;
        }

        return IsWithin(property, name, value, minimum, maximum) ? value : standard;
    }

    /// <summary>Returns true where a property's number is within a range; reports an error otherwise.</summary>
    public bool IsWithin(MitsubaElement property, string name, float value, float minimum, float maximum)
    {
        bool isWithin = value >= minimum && value <= maximum;
        if (!isWithin)
        {
            string range = float.IsInfinity(maximum) ? $"at least {minimum}" : $"from {minimum} to {maximum}";
            log.Error(property.PlaceOf("value"), string.Create(CultureInfo.InvariantCulture, $"{Quotation.Of(name)} must be {range}, but it is {value}"));
        }

        return isWithin;
    }

    /// <summary>A whole number.</summary>
    /// <param name="name">The property.</param>
    /// <param name="standard">The value where none is given.</param>
    /// <param name="minimum">The least that is allowed.</param>
    public int Integer(string name, int standard, int minimum = int.MinValue)
    {
        if (Property(name) is not { } property || !Is(property, "a whole number", "integer") || MitsubaNumbers.Integer(property, "value", log) is not { } value)
        {
            return standard;
        }

        if (value < minimum)
        {
            log.Error(property.PlaceOf("value"), $"{Quotation.Of(name)} must be at least {minimum}, but it is {value}");
            return standard;
        }

        return value;
    }

    /// <summary>True where something holds.</summary>
    public bool Boolean(string name, bool standard)
    {
        if (Property(name) is not { } property || !Is(property, "true or false", "boolean"))
        {
            return standard;
        }

        string text = property.Attribute("value") ?? "";
        if (text.ToLowerInvariant() is "true" or "false")
        {
            return text.Length == "true".Length;
        }

        log.Error(property.PlaceOf("value"), $"expected true or false for {Quotation.Of(name)}, but found {Quotation.Of(text)}");
        return standard;
    }

    /// <summary>A text; null where it is not given.</summary>
    public string? Text(string name) =>
        Property(name) is { } property && Is(property, "a string", "string") ? property.Attribute("value") ?? "" : null;

    /// <summary>One of several words.</summary>
    /// <param name="name">The property.</param>
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

        log.Unknown(_properties[name].PlaceOf("value"), $"{Quotation.Of(text)} is not a value that {Quotation.Of(name)} may have here", text, [.. words.Keys]);
        return standard;
    }

    /// <summary>A point or vector; null where it is not given.</summary>
    public Vector3? Vector(string name) =>
        Property(name) is { } property && Is(property, "a point or vector", "point", "vector") ? MitsubaNumbers.Vector(property, 0, log) : null;

    /// <summary>A transform; the identity where it is not given.</summary>
    public Transform Transform(string name = "to_world") =>
        Property(name) is { } property && Is(property, "a transform", "transform") ? MitsubaTransforms.Read(property, log) : Numerics.Transform.Identity;

    /// <summary>The file that a property names, as the scene's folder sees it; null, with an error, where it is not given.</summary>
    public string? FileName(string name = "filename")
    {
        if (Text(name) is { Length: > 0 } text)
        {
            return files.Find(text);
        }

        return log.Fail<string>(PlaceOf(name), $"{Describe()} needs {Quotation.Of(name)}, the path of a file");
    }

    /// <summary>The path of a file that is read at once.</summary>
    public string PathOf(string name) => files.Resolve(name);

    /// <summary>The thing of a kind under a name; null where there is none.</summary>
    public MitsubaObject? Child(string kind, string name)
    {
        _asked.Add(name);
        return Children(kind, c => c.Name == name).FirstOrDefault();
    }

    /// <summary>The only thing of a kind; null where there is none. More are errors.</summary>
    public MitsubaObject? Only(string kind, string? what = null)
    {
        (MitsubaChild Child, MitsubaObject Found)[] all = [.. Held(kind, _ => true)];
        foreach ((MitsubaChild second, _) in all.Skip(1))
        {
            log.Error(second.Place, $"{Describe()} may have only one {what ?? kind}");
        }

        return all.FirstOrDefault().Found;
    }

    /// <summary>The things of a kind within it, in their order.</summary>
    public IEnumerable<MitsubaObject> Children(string kind) => Children(kind, _ => true);

    /// <summary>True where there is a thing of a kind within it under a name.</summary>
    public bool HasChild(string name) => _children.Exists(c => c.Name == name);

    /// <summary>Says what nobody has asked for.</summary>
    public void Finish()
    {
        MitsubaRegistry.Current?.Add(Kind, Type, [.. _asked, .. _soughtAfter]);
        if (_isFinished)
        {
            return;
        }

        _isFinished = true;
        foreach ((string name, MitsubaElement property) in _properties.Where(p => !_asked.Contains(p.Key)))
        {
            string hint = ImportLog.Hint(name, [.. _asked.Where(a => a.Length > 0).Order(StringComparer.Ordinal)]);
            log.Unsupported(property.PlaceOf("name"), $"{Describe()} has no property {Quotation.Of(name)} here{hint}", "it is ignored");
        }

        foreach (MitsubaChild child in _children.Where(c => !_taken.Contains(c)))
        {
            if (child.Resolve() is { } stranger)
            {
                string name = child.Name.Length > 0 && !_asked.Contains(child.Name) ? $" named {Quotation.Of(child.Name)}{Spelling.DidYouMean(child.Name, _asked)}" : "";
                log.Unsupported(child.Place, $"{Describe()} can have no {stranger.Describe()}{name} here", "it is ignored");
            }
        }
    }

    /// <summary>Says that its type is none of those that are supported.</summary>
    public void UnknownType(string kinds, params string[] known)
    {
        MitsubaRegistry.Current?.Add(Kind, known);
        string message = $"{kinds} of type {Quotation.Of(Type)} are not supported";
        string end = MitsubaPlugins.ReasonOf(this) is { } reason ? $": {reason}" : ImportLog.Hint(Type, known);
        log.Unsupported(TypePlace, message + end, MitsubaPlugins.StandInOf(Kind));

        // Its properties say nothing to a stand-in.
        _isFinished |= log.IsLenient;
    }

    /// <summary>The name in messages.</summary>
    public string Describe() => Type.Length > 0 ? $"{Kind} {Quotation.Of(Type)}" : Kind;

    private IEnumerable<MitsubaObject> Children(string kind, Func<MitsubaChild, bool> isMeant) => Held(kind, isMeant).Select(h => h.Found);

    private IEnumerable<(MitsubaChild Child, MitsubaObject Found)> Held(string kind, Func<MitsubaChild, bool> isMeant)
    {
        foreach (MitsubaChild child in _children.Where(isMeant))
        {
            MitsubaObject? found = child.Resolve();
            LacksSomething |= found is null;
            if (found?.Kind == kind)
            {
                _taken.Add(child);
                yield return (child, found);
            }
        }
    }

    private bool Is(MitsubaElement property, string expected, params ReadOnlySpan<string> names)
    {
        bool isExpected = names.Contains(property.Name);
        if (!isExpected)
        {
            log.Error(property.Place, $"expected {expected} ({string.Join(" or ", names.ToArray().Select(n => $"<{n}>"))}) for {Quotation.Of(property.Attribute("name") ?? "")}, but found <{property.Name}>");
        }

        return isExpected;
    }
}

/// <summary>A thing within another one, or a reference to a thing.</summary>
/// <param name="Name">The name that it has within the other one; may be empty.</param>
/// <param name="Place">The position of it, or of the reference.</param>
/// <param name="Resolve">Finds the thing; null, after an error, where there is none.</param>
internal sealed record MitsubaChild(string Name, SourcePlace Place, Func<MitsubaObject?> Resolve);
