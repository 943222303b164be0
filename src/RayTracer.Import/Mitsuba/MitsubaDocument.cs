using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Import;

/// <summary>The things of a scene of XML files, with those of included files, with parameters' values and names put in.</summary>
internal sealed class MitsubaDocument
{
    private const int MaximumIncludes = 15;

    private static readonly string[] Objects =
        ["scene", "bsdf", "emitter", "film", "integrator", "medium", "phase", "rfilter", "sampler", "sensor", "shape", "texture", "volume"];

    private static readonly string[] Properties = ["float", "integer", "boolean", "string", "vector", "point", "rgb", "spectrum", "transform"];

    // Of properties, and of the steps of transforms.
    private static readonly Dictionary<string, string[]> s_attributes = """
        float: name value, integer: name value, boolean: name value, string: name value, rgb: name value, spectrum: name value filename,
        vector: name value x y z, point: name value x y z, transform: name,
        rotate: angle value x y z, lookat: origin target up, matrix: value, translate: value x y z, scale: value x y z
        """.Split([',', '\n', '\r'], StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries)
        .Select(entry => entry.Split(": ")).ToDictionary(entry => entry[0], entry => entry[1].Split(' '));

    private static readonly string[] s_ofObjects = ["type", "id", "name"];

    private static readonly string[] Others = ["ref", "include", "default", "alias", "path"];

    private readonly ImportLog _log;
    private readonly MitsubaParameters _parameters;
    private readonly Dictionary<string, MitsubaObject> _ids = new(StringComparer.Ordinal);

    // What each thing holds, in its own element or by reference; and what BreakLoops finds of that.
    private readonly Dictionary<MitsubaObject, List<Link>> _links = [];
    private readonly HashSet<MitsubaObject> _seen = [];
    private readonly HashSet<MitsubaObject> _open = [];
    private readonly HashSet<MitsubaElement> _loops = [];

    private MitsubaDocument(ImportLog log)
    {
        _log = log;
        _parameters = new(log);
    }

    /// <summary>Reads a scene.</summary>
    /// <param name="path">The file's path.</param>
    /// <param name="log">Takes what is wrong.</param>
    /// <returns>The scene; null where there is none.</returns>
    public static MitsubaObject? Read(string path, ImportLog log)
    {
        MitsubaDocument document = new(log);
        if (MitsubaXml.Read(path, log) is not { } root || !document.IsScene(root))
        {
            return null;
        }

        string home = Path.GetDirectoryName(path) ?? "";
        MitsubaFiles files = new(home, [home]);
        MitsubaObject scene = new(root, files, log);
        document.AddAll(scene, root, files, 0);
        document._parameters.Finish(root.Place);
        document.BreakLoops(scene);
        return scene;
    }

    // What would hold itself by way of references, or in too many steps, holds nothing there.
    private void BreakLoops(MitsubaObject thing)
    {
        _seen.Add(thing);
        _open.Add(thing);
        foreach (Link link in LinksOf(thing))
        {
            MitsubaObject? held = link.Held ?? _ids.GetValueOrDefault(link.Id);
            if (held is not null && _open.Contains(held))
            {
                _log.Error(link.Element.Place, $"{held.Describe()} contains itself");
                _loops.Add(link.Element);
            }
            else if (held is not null && _open.Count > MitsubaXml.MaximumNesting)
            {
                _log.Error(link.Element.Place, $"objects are nested more than {MitsubaXml.MaximumNesting} deep");
                _loops.Add(link.Element);
            }
            else if (held is not null && !_seen.Contains(held))
            {
                BreakLoops(held);
            }
        }

        _open.Remove(thing);
    }

    private List<Link> LinksOf(MitsubaObject thing) => _links.Remember(thing, () => []);

    private bool IsScene(MitsubaElement root)
    {
        if (root.Name != "scene")
        {
            _log.Error(root.Place, $"expected <scene> as the outermost element, but found <{root.Name}>");
            return false;
        }

        return HasVersion(root);
    }

    private bool HasVersion(MitsubaElement root)
    {
        if (root.Attribute("version") is not { } version)
        {
            _log.Error(root.Place, $"<{root.Name}> needs a version, such as version=\"3.0.0\"");
            return false;
        }

        bool isKnown = version.Split('.')[0] is "2" or "3";
        if (!isKnown)
        {
            _log.Error(root.PlaceOf("version"), $"files of the versions 2 and 3 are read, but this one is of version {Quotation.Of(version)}");
        }

        return isKnown;
    }

    private void AddAll(MitsubaObject parent, MitsubaElement element, MitsubaFiles files, int includes)
    {
        foreach (MitsubaElement child in element.Children)
        {
            AddChild(parent, _parameters.Substitute(child), files, includes);
        }
    }

    private void AddChild(MitsubaObject parent, MitsubaElement child, MitsubaFiles files, int includes)
    {
        bool isPlugin = child.Name == "spectrum" && child.Attributes.ContainsKey("type");
        if (isPlugin || Objects.Contains(child.Name))
        {
            AddObject(parent, child, files, includes);
        }
        else if (Properties.Contains(child.Name))
        {
            AddProperty(parent, child);
        }
        else
        {
            AddOther(parent, child, files, includes);
        }
    }

    private void AddObject(MitsubaObject parent, MitsubaElement child, MitsubaFiles files, int includes)
    {
        CheckAttributes(child, s_ofObjects);
        if (!child.Attributes.ContainsKey("type"))
        {
            _log.Error(child.Place, $"<{child.Name}> needs a type");
            return;
        }

        MitsubaObject made = new(child, files, _log);
        if (made.Id.Length > 0 && !_ids.TryAdd(made.Id, made))
        {
            SourcePlace first = _ids[made.Id].Place;
            _log.Error(child.PlaceOf("id"), $"the id {Quotation.Of(made.Id)} is already used in {Path.GetFileName(first.File)}, line {first.Line}");
        }

        AddAll(made, child, files, includes);
        parent.Add(new MitsubaChild(child.Attribute("name") ?? "", child.Place, () => made));
        LinksOf(parent).Add(new(child, made, ""));
    }

    private void AddProperty(MitsubaObject parent, MitsubaElement property)
    {
        CheckAttributes(property);
        if (property.Attribute("name") is not { } name)
        {
            _log.Error(property.Place, $"<{property.Name}> needs a name");
            return;
        }

        MitsubaElement expanded = property.Name == "transform" ? Expanded(property) : property;
        parent.Add(name, expanded);
    }

    // A transform's steps, with values in place of parameters.
    private MitsubaElement Expanded(MitsubaElement transform)
    {
        MitsubaElement expanded = new(transform.Name, transform.Place) { Children = [.. transform.Children.Select(_parameters.Substitute)] };
        foreach ((string name, MitsubaAttribute attribute) in transform.Attributes)
        {
            expanded.Attributes[name] = attribute;
        }

        expanded.Children.ForEach(CheckAttributes);
        return expanded;
    }

    private void AddOther(MitsubaObject parent, MitsubaElement child, MitsubaFiles files, int includes)
    {
        switch (child.Name)
        {
            case "ref":
                if (Need(child, "id") is { } id)
                {
                    parent.Add(new MitsubaChild(child.Attribute("name") ?? "", child.Place, () => _loops.Contains(child) ? null : Find(id, child)));
                    LinksOf(parent).Add(new(child, null, id));
                }

                break;
            case "default":
                if (Need(child, "name") is { } name && Need(child, "value") is { } value)
                {
                    _parameters.SetDefault(name, value);
                }

                break;
            case "alias":
                if (Need(child, "id") is { } of && Need(child, "as") is { } alias && Find(of, child) is { } known && !_ids.TryAdd(alias, known))
                {
                    _log.Error(child.PlaceOf("as"), $"the id {Quotation.Of(alias)} is already used");
                }

                break;
            case "path":
                AddFolder(child, files);
                break;
            case "include":
                Include(parent, child, files, includes);
                break;
            default:
                _log.Unknown(child.Place, $"<{child.Name}> has no meaning here", child.Name, [.. Objects, .. Properties, .. Others]);
                break;
        }
    }

    private void AddFolder(MitsubaElement path, MitsubaFiles files)
    {
        if (Need(path, "value") is { } folder)
        {
            string resolved = files.Resolve(folder);
            if (Directory.Exists(resolved))
            {
                files.Add(resolved);
            }
            else
            {
                _log.Error(path.PlaceOf("value"), $"there is no folder {Quotation.Of(folder)}");
            }
        }
    }

    private void Include(MitsubaObject parent, MitsubaElement include, MitsubaFiles files, int includes)
    {
        if (Need(include, "filename") is not { } name)
        {
            return;
        }

        if (includes == MaximumIncludes)
        {
            _log.Error(include.Place, $"files include one another more than {MaximumIncludes} deep");
            return;
        }

        string path = files.Resolve(name);
        if (FileSearch.Complaint(path) is { } complaint)
        {
            _log.Error(include.PlaceOf("filename"), $"cannot include {Quotation.Of(name)}: {complaint}");
            return;
        }

        if (MitsubaXml.Read(path, _log) is not { } root || !HasVersion(root))
        {
            return;
        }

        MitsubaFiles inner = files.For(Path.GetDirectoryName(path) ?? "");
        if (root.Name == "scene")
        {
            AddAll(parent, root, inner, includes + 1);
            return;
        }

        root.Attributes.Remove("version");
        AddChild(parent, _parameters.Substitute(root), inner, includes + 1);
    }

    private MitsubaObject? Find(string id, MitsubaElement reference)
    {
        if (!_ids.TryGetValue(id, out MitsubaObject? found))
        {
            _log.Unknown(reference.PlaceOf("id"), $"nothing has the id {Quotation.Of(id)}", id, _ids.Keys);
        }

        return found;
    }

    private string? Need(MitsubaElement element, string attribute)
    {
        string? value = element.Attribute(attribute);
        if (value is null)
        {
            _log.Error(element.Place, $"<{element.Name}> needs the attribute {Quotation.Of(attribute)}");
        }

        return value;
    }

    private void CheckAttributes(MitsubaElement element)
    {
        if (s_attributes.TryGetValue(element.Name, out string[]? known))
        {
            CheckAttributes(element, known);
        }
    }

    private void CheckAttributes(MitsubaElement element, string[] known)
    {
        foreach ((string name, MitsubaAttribute attribute) in element.Attributes.Where(a => !known.Contains(a.Key)))
        {
            _log.Unknown(attribute.Place, $"<{element.Name}> has no attribute {Quotation.Of(name)}", name, known);
        }
    }

    // A thing that another holds: itself, or the name by which it is referred to.
    private sealed record Link(MitsubaElement Element, MitsubaObject? Held, string Id);
}
