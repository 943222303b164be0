using Avalonia.Controls;

namespace RayTracer.Desktop.Views;

// Views that consist of their XAML alone.

/// <summary>The things that can be added.</summary>
internal sealed partial class AddView : UserControl
{
    /// <summary>Makes it.</summary>
    public AddView() => InitializeComponent();
}

/// <summary>A question over the window.</summary>
internal sealed partial class DialogView : UserControl
{
    /// <summary>Makes it.</summary>
    public DialogView() => InitializeComponent();
}

internal sealed partial class EnvironmentView : UserControl
{
    /// <summary>Makes it.</summary>
    public EnvironmentView() => InitializeComponent();
}

/// <summary>The name of a parameter, its editor, and the way back to its default.</summary>
internal sealed partial class FieldRow : UserControl
{
    /// <summary>Makes it.</summary>
    public FieldRow() => InitializeComponent();
}

/// <summary>The files that were opened last.</summary>
internal sealed partial class FilesView : UserControl
{
    /// <summary>Makes it.</summary>
    public FilesView() => InitializeComponent();
}

/// <summary>The scenes that come with the program.</summary>
internal sealed partial class GalleryView : UserControl
{
    /// <summary>Makes it.</summary>
    public GalleryView() => InitializeComponent();
}

internal sealed partial class MapsView : UserControl
{
    /// <summary>Makes it.</summary>
    public MapsView() => InitializeComponent();
}

/// <summary>Short messages over the window.</summary>
internal sealed partial class MessagesView : UserControl
{
    /// <summary>Makes it.</summary>
    public MessagesView() => InitializeComponent();
}

/// <summary>The tree of all things.</summary>
internal sealed partial class OutlinerView : UserControl
{
    /// <summary>Makes it.</summary>
    public OutlinerView() => InitializeComponent();
}

/// <summary>The light paths of one pixel.</summary>
internal sealed partial class PathsView : UserControl
{
    /// <summary>Makes it.</summary>
    public PathsView() => InitializeComponent();
}

/// <summary>The properties: of the selected thing, the camera, the rendering and the world.</summary>
internal sealed partial class PropertyPanelView : UserControl
{
    /// <summary>Makes it.</summary>
    public PropertyPanelView() => InitializeComponent();
}

/// <summary>Work of an earlier session that was not saved.</summary>
internal sealed partial class RecoveryView : UserControl
{
    /// <summary>Makes it.</summary>
    public RecoveryView() => InitializeComponent();
}

internal sealed partial class RenderView : UserControl
{
    /// <summary>Makes it.</summary>
    public RenderView() => InitializeComponent();
}

/// <summary>The progress of the rendering and of the jobs beside it.</summary>
internal sealed partial class StatusView : UserControl
{
    /// <summary>Makes it.</summary>
    public StatusView() => InitializeComponent();
}

/// <summary>The properties of one thing.</summary>
internal sealed partial class ThingView : UserControl
{
    /// <summary>Makes it.</summary>
    public ThingView() => InitializeComponent();
}

/// <summary>The report's times beside this machine's.</summary>
internal sealed partial class TimesView : UserControl
{
    /// <summary>Makes it.</summary>
    public TimesView() => InitializeComponent();
}

internal sealed partial class ViewportBar : UserControl
{
    /// <summary>Makes it.</summary>
    public ViewportBar() => InitializeComponent();
}
