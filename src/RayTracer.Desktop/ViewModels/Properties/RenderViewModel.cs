using System.Globalization;
using System.Windows.Input;
using CommunityToolkit.Mvvm.Input;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>The settings of the rendering, with presets.</summary>
internal sealed class RenderViewModel(SessionDispatcher dispatcher, PanelContext context) : Observable
{
    private static readonly (int Width, int Height)[] Sizes =
        [(300, 300), (400, 300), (600, 600), (800, 600), (1024, 768), (1280, 720), (1920, 1080), (3840, 2160)];
    private SessionState? _state;

    /// <summary>Presets of samples, the last of them as many as the scene says.</summary>
    public IReadOnlyList<Choice> Qualities { get; } =
        [.. new[] { "draft", "good", "final", "written" }.Select(q => new Choice(q, SessionTexts.Of($"render.{q}"), SessionTexts.Of($"render.{q}Why")))];

    /// <summary>The preset.</summary>
    public Choice? Quality
    {
        get => Qualities.First(q => q.Value == (_state?.Settings.Quality?.ToString().ToLowerInvariant() ?? "written"));
        set
        {
            if (!IsReporting && value is not null && value != Quality)
            {
                int? samples = Enum.TryParse(value.Value, ignoreCase: true, out RenderQuality quality) ? (int)quality : null;
                dispatcher.Do(s => s.View.Change(v => v with { Samples = samples }));
            }
        }
    }

    /// <summary>Sizes of pictures.</summary>
    public IReadOnlyList<Choice> PictureSizes { get; private set; } = [];

    /// <summary>The picture's size.</summary>
    public Choice? PictureSize
    {
        get => PictureSizes.FirstOrDefault(s => _state is { } state && s.Value == Key(state.Render.Width, state.Render.Height));
        set
        {
            if (IsReporting || value is null || value == PictureSize)
            {
                return;
            }

            int[] size = [.. value.Value.Split('x').Select(n => int.Parse(n, CultureInfo.InvariantCulture))];
            string gesture = Gesture.New();
            context.Set("/render/width", size[0], gesture);
            context.Set("/render/height", size[1], gesture);
        }
    }

    /// <summary>The number of threads, as it is typed.</summary>
    public string Threads
    {
        get => (_state?.Settings.Threads ?? 1).ToString(CultureInfo.InvariantCulture);
        set
        {
            if (Figures.Parse(value) is { } number && _state is not null && (int)number != _state.Settings.Threads)
            {
                int threads = Math.Clamp((int)number, 1, Environment.ProcessorCount);
                dispatcher.Do(s => s.View.Change(v => v with { Threads = threads }));
            }

            OnPropertyChanged();
        }
    }

    /// <summary>Adds threads, as many as the parameter says.</summary>
    public ICommand Step => field ??= new RelayCommand<object?>(steps =>
        Threads = ((_state?.Settings.Threads ?? 1) + Convert.ToInt32(steps, CultureInfo.InvariantCulture)).ToString(CultureInfo.InvariantCulture));

    /// <summary>Shows a state.</summary>
    public void Show(SessionState state)
    {
        if (_state is { } before && before.Settings == state.Settings && before.Render.Width == state.Render.Width && before.Render.Height == state.Render.Height)
        {
            return;
        }

        _state = state;
        (int width, int height) = (state.Render.Width, state.Render.Height);
        List<Choice> sizes = [.. Sizes.Select(s => new Choice(Key(s.Width, s.Height), SessionTexts.Of("status.size", s.Width, s.Height)))];
        if (width > 0 && sizes.TrueForAll(s => s.Value != Key(width, height)))
        {
            sizes.Insert(0, new(Key(width, height), $"{SessionTexts.Of("status.size", width, height)}, {SessionTexts.Of("render.ownSize")}"));
        }

        if (!sizes.SequenceEqual(PictureSizes))
        {
            PictureSizes = sizes;
        }

        OnPropertyChanged("");
    }

    private static string Key(int width, int height) => string.Create(CultureInfo.InvariantCulture, $"{width}x{height}");
}
