using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Scenes;

namespace RayTracer.Import;

/// <summary>Carries out the directives of a scene's files.</summary>
internal sealed class PbrtDocument
{
    private const int MaximumIncludes = 15;

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
    private readonly PbrtScope _scope;

    private PbrtDocument(PbrtFiles files, ImportLog log) => (_files, _log, _scope) = (files, log, new(log));

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
        document.Run(new(text, s_known, log), 0);
        document._scope.Finish();
        return document._world;
    }

    private void Run(PbrtArguments arguments, int includes)
    {
        while (arguments.Text.Next() is { } token)
        {
            if (token.IsQuoted || !s_known.Contains(token.Text))
            {
                string word = token.IsQuoted ? $"\"{token.Text}\"" : token.Text;
                _log.Unknown(token.Place, $"expected a directive, but found {Quotation.Of(word)}", token.Text, s_known);
                arguments.Skip();
            }
            else if (PbrtTransforms.Counts.TryGetValue(token.Text, out int count))
            {
                if (arguments.Numbers(token, count) is { } numbers)
                {
                    _scope.Move(token, numbers);
                }
            }
            else if (s_plain.Contains(token.Text))
            {
                Plain(token);
            }
            else if (s_things.TryGetValue(token.Text, out string? kind))
            {
                Place(token, kind, arguments);
            }
            else
            {
                Named(token, arguments, includes);
            }
        }
    }

    private void Plain(PbrtToken token)
    {
        switch (token.Text)
        {
            case "Identity":
                _scope.Identify();
                break;
            case "ReverseOrientation":
                _scope.State = _scope.State with { IsReversed = !_scope.State.IsReversed };
                break;
            case "AttributeBegin" or "TransformBegin":
                _scope.Save(token);
                break;
            case "AttributeEnd" or "TransformEnd" or "ObjectEnd":
                _scope.Restore(token);
                break;
            case "WorldBegin":
                _scope.BeginWorld();
                break;
            default:
                // WorldEnd, of earlier versions.
                break;
        }
    }

    private void Named(PbrtToken token, PbrtArguments arguments, int includes)
    {
        if (token.Text is "ActiveTransform")
        {
            Active(token, arguments);
        }
        else if (token.Text is "Option")
        {
            if (arguments.Parameter() is null)
            {
                _log.Error(token.Place, "Option needs a parameter, such as \"bool disablepixeljitter\" true");
            }

            _log.Warn(token.Place, "options say how pbrt works, and have no effect here");
        }
        else if (arguments.Name(token) is { } name)
        {
            Named(token, name, arguments, includes);
        }
    }

    private void Active(PbrtToken token, PbrtArguments arguments)
    {
        string which = arguments.Text.Next()?.Text ?? "";
        if (Array.Find(Enum.GetValues<PbrtTimes>(), t => t.ToString() == which) is var times && times != default)
        {
            _scope.Activate(times);
        }
        else
        {
            _log.Unknown(token.Place, $"expected All, StartTime or EndTime, but found {Quotation.Of(which)}", which, Enum.GetNames<PbrtTimes>());
        }
    }

    private void Named(PbrtToken token, PbrtToken name, PbrtArguments arguments, int includes)
    {
        switch (token.Text)
        {
            case "CoordinateSystem":
                _scope.NameSpace(name.Text);
                break;
            case "CoordSysTransform":
                _scope.EnterSpace(name);
                break;
            case "ObjectBegin":
                BeginObject(token, name);
                break;
            case "ObjectInstance":
                AddShape(new("instance", name.Text, token.Place, name.Place, _scope.State, _files, _log));
                break;
            case "Include" or "Import":
                Include(token, name, includes);
                break;
            case "ColorSpace":
                _scope.SetColorSpace(name);
                break;
            case "NamedMaterial":
                _scope.State = _scope.State with { Material = null, MaterialName = name.Text, MaterialPlace = name.Place };
                break;
            case "MediumInterface":
                _scope.State = _scope.State with { Inside = name.Text, Outside = arguments.Text.Peek() is { IsQuoted: true } ? arguments.Text.Next()!.Value.Text : name.Text };
                break;
            case "Attribute":
                AddAttributes(name, arguments);
                break;
            case "Texture":
                MakeTexture(token, name, arguments);
                break;
            default:
                Make(token, name, arguments);
                break;
        }
    }

    private void BeginObject(PbrtToken token, PbrtToken name)
    {
        if (_scope.Object is not null)
        {
            _log.Error(token.Place, "an object cannot hold another one");
        }

        _scope.Save(token);
        _scope.Object = [];
        if (!_world.Objects.TryAdd(name.Text, _scope.Object))
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

        PbrtState before = _scope.State;
        if (PbrtText.Open(_files.Resolve(name.Text), name.Place, $"cannot include {Quotation.Of(name.Text)}: ", _log) is { } inner)
        {
            Run(new(inner, s_known, _log), includes + 1);
        }

        // What an imported file sets holds for itself only.
        _scope.State = token.Text == "Import" ? before : _scope.State;
    }

    private void AddAttributes(PbrtToken target, PbrtArguments arguments)
    {
        string[] targets = ["shape", "light", "material", "medium", "texture"];
        if (!targets.Contains(target.Text))
        {
            _log.Unknown(target.Place, $"attributes are given to shapes, lights, materials, media or textures, not to {Quotation.Of(target.Text)}", target.Text, targets);
        }

        while (arguments.Parameter() is { } parameter)
        {
            _scope.State = _scope.State with { Attributes = _scope.State.Attributes.RemoveAll(a => a.Kind == target.Text && a.Parameter.Name == parameter.Name).Add((target.Text, parameter)) };
        }
    }

    private void MakeTexture(PbrtToken token, PbrtToken name, PbrtArguments arguments)
    {
        if (arguments.Name(token) is not { } of || arguments.Name(token) is not { } type)
        {
            return;
        }

        if (of.Text is not ("float" or "spectrum"))
        {
            _log.Unknown(of.Place, $"a texture is of float or spectrum, not of {Quotation.Of(of.Text)}", of.Text, ["float", "spectrum"]);
        }

        PbrtThing made = Thing("texture", token, type, arguments);
        if (!_world.Textures.TryAdd((of.Text, name.Text), made))
        {
            _log.Error(name.Place, $"the texture {Quotation.Of(name.Text)} is defined twice");
        }
    }

    // What has a name, and says its type by a parameter.
    private void Make(PbrtToken token, PbrtToken name, PbrtArguments arguments)
    {
        string kind = token.Text == "MakeNamedMedium" ? "medium" : "material";
        List<PbrtParameter> parameters = [];
        while (arguments.Parameter() is { } parameter)
        {
            parameters.Add(parameter);
        }

        PbrtParameter? type = parameters.Find(p => p is { Name: "type", Type: "string", Words.Count: 1 });
        if (type is null)
        {
            _log.Error(token.Place, $"{token.Text} needs a parameter \"string type\"");
            return;
        }

        PbrtThing made = new(kind, type.Words[0], token.Place, type.Place, _scope.State, _files, _log);
        made.Ignore("type");
        parameters.ForEach(made.Add);
        Inherit(made, kind);
        if (!(kind == "medium" ? _world.Media : _world.Materials).TryAdd(name.Text, made))
        {
            _log.Error(name.Place, $"the {kind} {Quotation.Of(name.Text)} is defined twice");
        }
    }

    private void Place(PbrtToken token, string kind, PbrtArguments arguments)
    {
        if (arguments.Name(token) is not { } type)
        {
            return;
        }

        PbrtThing thing = Thing(kind, token, type, arguments);
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
                _scope.State = _scope.State with { Light = thing };
                break;
            case "material":
                _scope.State = _scope.State with { Material = thing, MaterialName = "" };
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
        if (_scope.IsWorld)
        {
            _log.Error(thing.Place, $"the {thing.Kind} must stand before WorldBegin");
        }

        if (!_world.Only.TryAdd(thing.Kind, thing))
        {
            _log.Error(thing.Place, $"the {thing.Kind} is given twice");
        }

        if (thing.Kind == "camera")
        {
            _scope.NameCamera();
        }
    }

    private void AddShape(PbrtThing thing)
    {
        CheckWorld(thing);
        if (thing.Kind == "instance" && _scope.Object is not null)
        {
            _log.Error(thing.Place, "an object cannot hold an instance");
        }

        (_scope.Object ?? _world.Shapes).Add(thing);
    }

    private void CheckWorld(PbrtThing thing)
    {
        if (!_scope.IsWorld)
        {
            _log.Error(thing.Place, $"a {thing.Kind} must stand after WorldBegin");
        }
    }

    private PbrtThing Thing(string kind, PbrtToken token, PbrtToken type, PbrtArguments arguments)
    {
        PbrtThing thing = new(kind, type.Text, token.Place, type.Place, _scope.State, _files, _log);
        while (arguments.Parameter() is { } parameter)
        {
            thing.Add(parameter);
        }

        Inherit(thing, kind == "area light" ? "light" : kind);
        return thing;
    }

    private void Inherit(PbrtThing thing, string kind)
    {
        foreach ((_, PbrtParameter parameter) in _scope.State.Attributes.Where(a => a.Kind == kind))
        {
            thing.Inherit(parameter);
        }
    }
}
