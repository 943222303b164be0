using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Scenes;

namespace RayTracer.Import;

/// <summary>What holds at the place of a scene's files that is read, and the blocks that it stands in (pbrt's graphics state and its stack).</summary>
/// <param name="log">Takes what is wrong.</param>
internal sealed class PbrtScope(ImportLog log)
{
    private const int MaximumNesting = 256;
    private readonly Stack<(PbrtState State, string Directive, SourcePlace Place)> _saved = [];
    private readonly Dictionary<string, PbrtPlaces> _spaces = new(StringComparer.Ordinal);

    /// <summary>What holds now.</summary>
    public PbrtState State { get; set; } = new();

    /// <summary>The shapes of the object that is being defined; null outside of objects.</summary>
    public List<PbrtThing>? Object { get; set; }

    /// <summary>True after WorldBegin.</summary>
    public bool IsWorld { get; private set; }

    /// <summary>Begins the world, in whose space things stand from then on.</summary>
    public void BeginWorld()
    {
        _spaces["camera"] = _spaces.GetValueOrDefault("camera", PbrtPlaces.World);
        State = State with { Places = PbrtPlaces.World, Active = PbrtTimes.All };
        _spaces["world"] = PbrtPlaces.World;
        IsWorld = true;
    }

    /// <summary>Gives the space in which things stand now a name.</summary>
    public void NameSpace(string name) => _spaces[name] = State.Places;

    /// <summary>The camera stands here.</summary>
    public void NameCamera() => _spaces["camera"] = State.Places.Select(p => p.Inverse());

    /// <summary>Goes to a space by its name.</summary>
    public void EnterSpace(PbrtToken name)
    {
        if (_spaces.TryGetValue(name.Text, out PbrtPlaces space))
        {
            State = State with { Places = space };
        }
        else
        {
            log.Unknown(name.Place, $"there is no coordinate system {Quotation.Of(name.Text)}", name.Text, _spaces.Keys);
        }
    }

    /// <summary>Reports the blocks that are still open.</summary>
    public void Finish()
    {
        foreach ((_, string directive, SourcePlace place) in _saved)
        {
            log.Error(place, $"{directive} has no {directive.Replace("Begin", "End", StringComparison.Ordinal)}");
        }
    }

    /// <summary>Begins a block.</summary>
    public void Save(PbrtToken token)
    {
        if (_saved.Count == MaximumNesting)
        {
            log.Error(token.Place, $"blocks are nested more than {MaximumNesting} deep");
        }

        _saved.Push((State, token.Text, token.Place));
    }

    /// <summary>Ends a block.</summary>
    public void Restore(PbrtToken token)
    {
        string begin = token.Text.Replace("End", "Begin", StringComparison.Ordinal);
        if (!_saved.TryPeek(out (PbrtState State, string Directive, SourcePlace Place) last) || last.Directive != begin)
        {
            string open = last.Directive is null ? "nothing is open" : $"{last.Directive} of line {last.Place.Line} is open";
            log.Error(token.Place, $"{token.Text} without {begin}: {open}");
            return;
        }

        _saved.Pop();
        State = token.Text == "TransformEnd" ? State with { Places = last.State.Places, Active = last.State.Active } : last.State;
        Object = token.Text == "ObjectEnd" ? null : Object;
    }

    /// <summary>Applies a transform.</summary>
    /// <param name="token">The directive.</param>
    /// <param name="numbers">Its numbers.</param>
    public void Move(PbrtToken token, float[] numbers)
    {
        if (token.Text == "TransformTimes")
        {
            State = State with { Times = (numbers[0], numbers[1]) };
        }
        else if (PbrtTransforms.Of(token.Text, numbers, out string? complaint) is { } map && Moved(before => token.Text == "Transform" ? map : before * map) is { Start.IsInvertible: true, End.IsInvertible: true } places)
        {
            State = State with { Places = places };
        }
        else
        {
            log.Error(token.Place, complaint ?? "the transform flattens what follows, or has numbers too large or too small to compute with");
        }
    }

    /// <summary>Goes to the world's own space.</summary>
    public void Identify() => State = State with { Places = Moved(_ => Transform.Identity) };

    /// <summary>Says which transforms the following directives change.</summary>
    public void Activate(PbrtTimes times) => State = State with { Active = times };

    private PbrtPlaces Moved(Func<Transform, Transform> change) => new(
        State.Active.HasFlag(PbrtTimes.StartTime) ? change(State.Places.Start) : State.Places.Start,
        State.Active.HasFlag(PbrtTimes.EndTime) ? change(State.Places.End) : State.Places.End);

    /// <summary>Takes a colour space for the numbers that follow.</summary>
    public void SetColorSpace(PbrtToken name)
    {
        if (PbrtColors.Spaces.Contains(name.Text))
        {
            State = State with { ColorSpace = name.Text };
        }
        else
        {
            log.Unsupported(name.Place, $"the colour space {Quotation.Of(name.Text)} is not supported{ImportLog.Hint(name.Text, PbrtColors.Spaces)}", "numbers are taken for linear sRGB");
        }
    }
}
