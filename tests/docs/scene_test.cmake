# Renders the scene of docs/scenes.md: cmake -D AUREOLE=... -D SCENE=... -D OUT=... -P scene_test.cmake
file(REMOVE "${OUT}")
execute_process(COMMAND "${AUREOLE}" render "${SCENE}" -o "${OUT}" --size 32x18 --quality low --backend cpu RESULT_VARIABLE result)
if(NOT result EQUAL 0 OR NOT EXISTS "${OUT}")
    message(FATAL_ERROR "the scene on the page is not rendered")
endif()
