#include "engine.h"

#include <OgreCamera.h>
#include <OgreHardwarePixelBuffer.h>
#include <OgreLight.h>
#include <OgreLogManager.h>
#include <OgreMaterialManager.h>
#include <OgreRectangle2D.h>
#include <OgreRenderTexture.h>
#include <OgreRenderWindow.h>
#include <OgreResourceGroupManager.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <OgreTechnique.h>
#include <OgreTextureManager.h>
#include <OgreViewport.h>

namespace aureole::ogre {
namespace {

const Ogre::String& group() { return Ogre::ResourceGroupManager::DEFAULT_RESOURCE_GROUP_NAME; }

Ogre::Pass& pass_of(const char* material) {
    const Ogre::MaterialPtr found = Ogre::MaterialManager::getSingleton().getByName(material, group());
    found->load();
    return *found->getTechnique(0)->getPass(0);
}

}  // namespace

Engine::Engine(std::uint32_t width, std::uint32_t height) {
    start(width, height);
    load_materials();
    colour_ = make_texture("scene colour", Ogre::PF_FLOAT16_RGBA, Ogre::TU_RENDERTARGET);
    depth_ = make_texture("scene depth", Ogre::PF_FLOAT32_R, Ogre::TU_RENDERTARGET);
    picture_ = make_texture("picture", Ogre::PF_FLOAT16_RGBA, Ogre::TU_DYNAMIC);
    make_scene_target();
    make_show();
}

Engine::~Engine() = default;

void Engine::start(std::uint32_t width, std::uint32_t height) {
    auto* logs = new Ogre::LogManager();  // the root's from here on
    logs->createLog("ogre.log", true, false, true);
    root_ = std::make_unique<Ogre::Root>("", "", "");
    root_->loadPlugin(AUREOLE_OGRE_PLUGINS "/RenderSystem_GL3Plus");
    Ogre::RenderSystem* gl = root_->getAvailableRenderers().front();
    root_->setRenderSystem(gl);
    root_->initialise(false);
    const Ogre::NameValuePairList parameters{{"currentGLContext", "true"}, {"externalGLControl", "true"}};
    window_ = root_->createRenderWindow("window", width, height, false, &parameters);
}

void Engine::load_materials() {
    auto& resources = Ogre::ResourceGroupManager::getSingleton();
    // The second for what show.frag includes.
    for (const char* folder : {AUREOLE_OGRE_MEDIA, AUREOLE_OGRE_GLSL})
        resources.addResourceLocation(folder, "FileSystem", group());
    resources.initialiseResourceGroup(group());
}

Ogre::TexturePtr Engine::make_texture(const char* name, Ogre::PixelFormat format, int usage) const {
    return Ogre::TextureManager::getSingleton().createManual(name, group(), Ogre::TEX_TYPE_2D, window_->getWidth(),
                                                             window_->getHeight(), 0, format, usage);
}

void Engine::make_scene_target() {
    scene_ = root_->createSceneManager();
    camera_ = scene_->createCamera("camera");
    scene_->getRootSceneNode()->createChildSceneNode("eye")->attachObject(camera_);
    sun_ = scene_->createLight();
    sun_->setType(Ogre::Light::LT_DIRECTIONAL);
    sun_node_ = scene_->getRootSceneNode()->createChildSceneNode();
    sun_node_->attachObject(sun_);

    Ogre::MultiRenderTarget* target = root_->getRenderSystem()->createMultiRenderTarget("scene");
    target->bindSurface(0, colour_->getBuffer()->getRenderTarget());
    target->bindSurface(1, depth_->getBuffer()->getRenderTarget());
    Ogre::Viewport* viewport = target->addViewport(camera_);
    viewport->setBackgroundColour(Ogre::ColourValue(0, 0, 0, 0));  // black, and the depth of what is infinitely far
    viewport->setOverlaysEnabled(false);
    target->setPriority(0);  // before the window
    target->setAutoUpdated(true);
    target->addListener(this);
}

void Engine::make_show() {
    show_ = root_->createSceneManager();
    show_camera_ = show_->createCamera("show");
    show_->getRootSceneNode()->attachObject(show_camera_);
    auto* rectangle = new Ogre::Rectangle2D(true);
    rectangle->setCorners(-1, 1, 1, -1);
    rectangle->setBoundingBox(Ogre::AxisAlignedBox::BOX_INFINITE);
    pass_of("aureole/show").getTextureUnitState(0)->setTexture(picture_);
    rectangle->setMaterial(Ogre::MaterialManager::getSingleton().getByName("aureole/show", group()));
    show_->getRootSceneNode()->createChildSceneNode()->attachObject(rectangle);
    Ogre::Viewport* viewport = window_->addViewport(show_camera_);
    viewport->setOverlaysEnabled(false);
}

void Engine::set_light(const Ogre::Vector3& towards, const Ogre::ColourValue& sun, const Ogre::ColourValue& sky) {
    sun_node_->setDirection(-towards, Ogre::Node::TS_WORLD);
    sun_->setDiffuseColour(sun);
    scene_->setAmbientLight(sky);
}

const Ogre::ColourValue& Engine::sun_colour() const { return sun_->getDiffuseColour(); }
const Ogre::ColourValue& Engine::sky_colour() const { return scene_->getAmbientLight(); }

void Engine::set_exposure(float exposure) {
    pass_of("aureole/show").getFragmentProgramParameters()->setNamedConstant("exposure", exposure);
}

void Engine::postRenderTargetUpdate(const Ogre::RenderTargetEvent&) {
    if (after_scene_) after_scene_();
}

void Engine::draw_frame() { root_->renderOneFrame(); }

std::vector<std::uint8_t> Engine::read_window() {
    const Ogre::uint32 width = window_->getWidth(), height = window_->getHeight();
    std::vector<std::uint8_t> rgb(std::size_t{3} * width * height);
    const Ogre::PixelBox box(width, height, 1, Ogre::PF_BYTE_RGB, rgb.data());
    window_->copyContentsToMemory(Ogre::Box(0, 0, width, height), box, Ogre::RenderTarget::FB_BACK);
    return rgb;
}

std::vector<float> Engine::read(const Ogre::TexturePtr& texture) {
    std::vector<float> rgba(std::size_t{4} * texture->getWidth() * texture->getHeight());
    const Ogre::PixelBox box(texture->getWidth(), texture->getHeight(), 1, Ogre::PF_FLOAT32_RGBA, rgba.data());
    texture->getBuffer()->blitToMemory(box);
    return rgba;
}

}  // namespace aureole::ogre
