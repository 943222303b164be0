using System.Globalization;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Scenes;

namespace RayTracer.Import;

/// <summary>Carries out the directives of a scene's files.</summary>
internal sealed class PbrtDocument
{
    private const int MaximumIncludes = 15;
    private const int MaximumNesting = 256;

    // Of directives that make a thing, its kind.
    private static readonly Dictionary<string, string> s_things = new(StringComparer.Ordinal)
    {
        ["Camera"] = "camera",
        ["Film"] = "film",
        ["Sampler"] = "sampler",
        ["PixelFilter"] = "filter",
        ["Integrator"] = "integrator",
        ["Accelerator"] = "accelerator",
        ["Shape"] = "shape",
        ["LightSource"] = "light",
        ["AreaLightSource"] = "area light",
        ["Material"] = "material",
    };

    private static readonly string[] s_plain =
        ["Identity", "ReverseOrientation", "AttributeBegin", "AttributeEnd", "TransformBegin", "TransformEnd", "ObjectEnd", "WorldBegin", "WorldEnd"];

    private static readonly string[] s_named =
        ["CoordinateSystem", "CoordSysTransform", "ObjectBegin", "ObjectInstance", "Include", "Import", "ColorSpace", "NamedMaterial", "MakeNamedMaterial", "MakeNamedMedium", "MediumInterface", "Attribute", "Option", "ActiveTransform", "Texture"];

    private static readonly string[] s_known = [.. s_things.Keys, .. PbrtTransforms.Counts.Keys, .. s_plain, .. s_named];

    private readonly ImportLog _log;
    private readonly PbrtFiles _files;
    private readonly PbrtWorld _world = new();
    private readonly Stack<(PbrtState State, string Directive, SourcePlace Place)> _saved = [];
    private readonly Dictionary<string, Transform> _spaces = new(StringComparer.Ordinal);
    private PbrtState _state = new();
    private List<PbrtThing>? _object;
    private bool _isWorld;

    private PbrtDocument(PbrtFiles files, ImportLog log) => (_files, _log) = (files, log);

    /// <summary>Reads a scene.</summary>
    /// <param name="path">The file's path.</param>
    /// <param name="log">Takes what is wrong.</param>
    /// <returns>The things of the scene; null where its file cannot be read.</returns>
    public static PbrtWorld? Read(string path, ImportLog log)
    {
        if (PbrtText.Open(path, new(path, 0, 0), "", log) is not { } text)
        {
            return null;
        }

        PbrtDocument document = new(new(Path.GetDirectoryName(path) ?? ""), log);
        document.Run(text, 0);
        foreach ((_, string directive, SourcePlace place) in document._saved)
        {
            log.Error(place, $"{directive} has no {directive.Replace("Begin", "End", StringComparison.Ordinal)}");
        }

        return document._world;
    }

    private void Run(PbrtText text, int includes)
    {
        while (text.Next() is { } token)
        {
            if (token.IsQuoted || !s_known.Contains(token.Text))
            {
                string word = token.IsQuoted ? $"\"{token.Text}\"" : token.Text;
                _log.Unknown(token.Place, $"expected a directive, but found {Quotation.Of(word)}", token.Text, s_known);
                SkipArguments(text);
            }
            else if (PbrtTransforms.Counts.TryGetValue(token.Text, out int count))
            {
                if (Numbers(text, token, count) is { } numbers)
                {
                    Move(token, numbers);
                }
            }
            else if (s_plain.Contains(token.Text))
            {
                Plain(token);
            }
            else if (s_things.TryGetValue(token.Text, out string? kind))
            {
                Place(token, kind, text);
            }
            else
            {
                Named(token, text, includes);
            }
        }
    }

    // What follows an unknown word, up to the next directive.
    private static void SkipArguments(PbrtText text)
    {
        while (text.Peek() is { } next && (next.IsQuoted || !s_known.Contains(next.Text)))
        {
            text.Next();
        }
    }

    private void Plain(PbrtToken token)
    {
        switch (token.Text)
        {
            case "Identity":
                _state = _state with { Place = Transform.Identity };
                break;
            case "ReverseOrientation":
                _state = _state with { IsReversed = !_state.IsReversed };
                break;
            case "AttributeBegin" or "TransformBegin":
                Save(token);
                break;
            case "AttributeEnd" or "TransformEnd" or "ObjectEnd":
                Restore(token);
                break;
            case "WorldBegin":
                _spaces["camera"] = _spaces.GetValueOrDefault("camera", Transform.Identity);
                _state = _state with { Place = Transform.Identity };
                _spaces["world"] = Transform.Identity;
                _isWorld = true;
                break;
            default:
                // WorldEnd, of earlier versions.
                break;
        }
    }

    private void Save(PbrtToken token)
    {
        if (_saved.Count == MaximumNesting)
        {
            _log.Error(token.Place, $"blocks are nested more than {MaximumNesting} deep");
        }

        _saved.Push((_state, token.Text, token.Place));
    }

    private void Restore(PbrtToken token)
    {
        string begin = token.Text.Replace("End", "Begin", StringComparison.Ordinal);
        if (!_saved.TryPeek(out (PbrtState State, string Directive, SourcePlace Place) last) || last.Directive != begin)
        {
            string open = last.Directive is null ? "nothing is open" : $"{last.Directive} of line {last.Place.Line} is open";
            _log.Error(token.Place, $"{token.Text} without {begin}: {open}");
            return;
        }

        _saved.Pop();
        _state = token.Text == "TransformEnd" ? _state with { Place = last.State.Place } : last.State;
        _object = token.Text == "ObjectEnd" ? null : _object;
    }

    private void Move(PbrtToken token, float[] numbers)
    {
        Transform before = token.Text == "Transform" ? Transform.Identity : _state.Place;
        if (PbrtTransforms.Of(token.Text, numbers, out string? complaint) is { } map && before * map is { IsInvertible: true } all)
        {
            _state = _state with { Place = all };
        }
        else
        {
            _log.Error(token.Place, complaint ?? "the transform flattens what follows, or has numbers too large or too small to compute with");
        }
    }

    private void Named(PbrtToken token, PbrtText text, int includes)
    {
        if (token.Text is "ActiveTransform")
        {
            Active(token, text);
        }
        else if (token.Text is "Option")
        {
            if (Parameter(text) is null)
            {
                _log.Error(token.Place, "Option needs a parameter, such as \"bool disablepixeljitter\" true");
            }

            _log.Warn(token.Place, "options say how pbrt works, and have no effect here");
        }
        else if (Name(token, text) is { } name)
        {
            Named(token, name, text, includes);
        }
    }

    private void Active(PbrtToken token, PbrtText text)
    {
        string which = text.Next()?.Text ?? "";
        if (which is not ("All" or "StartTime" or "EndTime"))
        {
            _log.Unknown(token.Place, $"expected All, StartTime or EndTime, but found {Quotation.Of(which)}", which, ["All", "StartTime", "EndTime"]);
        }
        else if (which != "All")
        {
            _log.Unsupported(token.Place, "what moves while the shutter is open is not supported (ActiveTransform)", "both transforms count, one after the other");
        }
    }

    private void Named(PbrtToken token, PbrtToken name, PbrtText text, int includes)
    {
        switch (token.Text)
        {
            case "CoordinateSystem":
                _spaces[name.Text] = _state.Place;
                break;
            case "CoordSysTransform":
                if (_spaces.TryGetValue(name.Text, out Transform space))
                {
                    _state = _state with { Place = space };
                }
                else
                {
                    _log.Unknown(name.Place, $"there is no coordinate system {Quotation.Of(name.Text)}", name.Text, _spaces.Keys);
                }

                break;
            case "ObjectBegin":
                BeginObject(token, name);
                break;
            case "ObjectInstance":
                AddShape(new("instance", name.Text, token.Place, name.Place, _state, _files, _log));
                break;
            case "Include" or "Import":
                Include(token, name, includes);
                break;
            case "ColorSpace":
                SetColorSpace(name);
                break;
            case "NamedMaterial":
                _state = _state with { Material = null, MaterialName = name.Text, MaterialPlace = name.Place };
                break;
            case "MediumInterface":
                _state = _state with { Inside = name.Text, Outside = text.Peek() is { IsQuoted: true } ? text.Next()!.Value.Text : name.Text };
                break;
            case "Attribute":
                AddAttributes(name, text);
                break;
            case "Texture":
                MakeTexture(token, name, text);
                break;
            default:
                Make(token, name, text);
                break;
        }
    }

    private void SetColorSpace(PbrtToken name)
    {
        if (PbrtColors.Spaces.Contains(name.Text))
        {
            _state = _state with { ColorSpace = name.Text };
        }
        else
        {
            _log.Unsupported(name.Place, $"the colour space {Quotation.Of(name.Text)} is not supported{ImportLog.Hint(name.Text, PbrtColors.Spaces)}", "numbers are taken for linear sRGB");
        }
    }

    private void BeginObject(PbrtToken token, PbrtToken name)
    {
        if (_object is not null)
        {
            _log.Error(token.Place, "an object cannot hold another one");
        }

        Save(token);
        _object = [];
        if (!_world.Objects.TryAdd(name.Text, _object))
        {
            _log.Error(name.Place, $"the object {Quotation.Of(name.Text)} is defined twice");
        }
    }

    private void Include(PbrtToken token, PbrtToken name, int includes)
    {
        if (includes == MaximumIncludes)
        {
            _log.Error(token.Place, $"files include one another more than {MaximumIncludes} deep");
            return;
        }

        PbrtState before = _state;
        if (PbrtText.Open(_files.Resolve(name.Text), name.Place, $"cannot include {Quotation.Of(name.Text)}: ", _log) is { } inner)
        {
            Run(inner, includes + 1);
        }

        // What an imported file sets holds for itself only.
        _state = token.Text == "Import" ? before : _state;
    }

    private void AddAttributes(PbrtToken target, PbrtText text)
    {
        string[] targets = ["shape", "light", "material", "medium", "texture"];
        if (!targets.Contains(target.Text))
        {
            _log.Unknown(target.Place, $"attributes are given to shapes, lights, materials, media or textures, not to {Quotation.Of(target.Text)}", target.Text, targets);
        }

        while (Parameter(text) is { } parameter)
        {
            _state = _state with { Attributes = _state.Attributes.RemoveAll(a => a.Kind == target.Text && a.Parameter.Name == parameter.Name).Add((target.Text, parameter)) };
        }
    }

    private void MakeTexture(PbrtToken token, PbrtToken name, PbrtText text)
    {
        if (Name(token, text) is not { } of || Name(token, text) is not { } type)
        {
            return;
        }

        if (of.Text is not ("float" or "spectrum"))
        {
            _log.Unknown(of.Place, $"a texture is of float or spectrum, not of {Quotation.Of(of.Text)}", of.Text, ["float", "spectrum"]);
        }

        PbrtThing made = Thing("texture", token, type, text);
        if (!_world.Textures.TryAdd((of.Text, name.Text), made))
        {
            _log.Error(name.Place, $"the texture {Quotation.Of(name.Text)} is defined twice");
        }
    }

    // What has a name, and says its type by a parameter.
    private void Make(PbrtToken token, PbrtToken name, PbrtText text)
    {
        string kind = token.Text == "MakeNamedMedium" ? "medium" : "material";
        List<PbrtParameter> parameters = [];
        while (Parameter(text) is { } parameter)
        {
            parameters.Add(parameter);
        }

        PbrtParameter? type = parameters.Find(p => p is { Name: "type", Type: "string", Words.Count: 1 });
        if (type is null)
        {
            _log.Error(token.Place, $"{token.Text} needs a parameter \"string type\"");
            return;
        }

        PbrtThing made = new(kind, type.Words[0], token.Place, type.Place, _state, _files, _log);
        made.Ignore("type");
        parameters.ForEach(made.Add);
        Inherit(made, kind);
        if (!(kind == "medium" ? _world.Media : _world.Materials).TryAdd(name.Text, made))
        {
            _log.Error(name.Place, $"the {kind} {Quotation.Of(name.Text)} is defined twice");
        }
    }

    private void Place(PbrtToken token, string kind, PbrtText text)
    {
        if (Name(token, text) is not { } type)
        {
            return;
        }

        PbrtThing thing = Thing(kind, token, type, text);
        switch (kind)
        {
            case "shape":
                AddShape(thing);
                break;
            case "light":
                CheckWorld(thing);
                _world.Lights.Add(thing);
                break;
            case "area light":
                _state = _state with { Light = thing };
                break;
            case "material":
                _state = _state with { Material = thing, MaterialName = "" };
                break;
            case "accelerator":
                break;
            default:
                AddOnly(thing);
                break;
        }
    }

    private void AddOnly(PbrtThing thing)
    {
        if (_isWorld)
        {
            _log.Error(thing.Place, $"the {thing.Kind} must stand before WorldBegin");
        }

        if (!_world.Only.TryAdd(thing.Kind, thing))
        {
            _log.Error(thing.Place, $"the {thing.Kind} is given twice");
        }

        if (thing.Kind == "camera")
        {
            _spaces["camera"] = _state.Place.Inverse();
        }
    }

    private void AddShape(PbrtThing thing)
    {
        CheckWorld(thing);
        if (thing.Kind == "instance" && _object is not null)
        {
            _log.Error(thing.Place, "an object cannot hold an instance");
        }

        (_object ?? _world.Shapes).Add(thing);
    }

    private void CheckWorld(PbrtThing thing)
    {
        if (!_isWorld)
        {
            _log.Error(thing.Place, $"a {thing.Kind} must stand after WorldBegin");
        }
    }

    private PbrtThing Thing(string kind, PbrtToken token, PbrtToken type, PbrtText text)
    {
        PbrtThing thing = new(kind, type.Text, token.Place, type.Place, _state, _files, _log);
        while (Parameter(text) is { } parameter)
        {
            thing.Add(parameter);
        }

        Inherit(thing, kind == "area light" ? "light" : kind);
        return thing;
    }

    private void Inherit(PbrtThing thing, string kind)
    {
        foreach ((_, PbrtParameter parameter) in _state.Attributes.Where(a => a.Kind == kind))
        {
            thing.Inherit(parameter);
        }
    }

    private PbrtToken? Name(PbrtToken token, PbrtText text)
    {
        if (text.Peek() is { IsQuoted: true })
        {
            return text.Next();
        }

        _log.Error(text.Peek()?.Place ?? text.Place, $"{token.Text} needs a name in quotation marks, but found {(text.Peek() is { } other ? Quotation.Of(other.Text) : "the end of the file")}");
        SkipArguments(text);
        return null;
    }

    private PbrtParameter? Parameter(PbrtText text)
    {
        while (text.Peek() is { IsQuoted: true } declaration)
        {
            text.Next();
            if (new PbrtValues(_log).Read(declaration, text) is { } parameter)
            {
                return parameter;
            }
        }

        return null;
    }

    private float[]? Numbers(PbrtText text, PbrtToken token, int count)
    {
        bool isBracketed = text.Peek()?.Is("[") == true;
        if (isBracketed)
        {
            text.Next();
        }

        float[] numbers = new float[count];
        for (int i = 0; i < count; i++)
        {
            if (text.Peek() is not { IsQuoted: false } word || !float.TryParse(word.Text, NumberStyles.Float, CultureInfo.InvariantCulture, out numbers[i]) || !float.IsFinite(numbers[i]))
            {
                string found = text.Peek() is { } other ? Quotation.Of(other.Text) : "the end of the file";
                _log.Error(text.Peek()?.Place ?? text.Place, $"{token.Text} needs {count} numbers, but after {i} of them there is {found}");
                SkipArguments(text);
                return null;
            }

            text.Next();
        }

        if (isBracketed && text.Peek()?.Is("]") == true)
        {
            text.Next();
        }
        else if (isBracketed)
        {
            _log.Error(text.Peek()?.Place ?? text.Place, $"expected ] after the {count} numbers of {token.Text}");
            SkipArguments(text);
        }

        return numbers;
    }
}
